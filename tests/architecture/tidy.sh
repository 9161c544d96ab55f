#!/usr/bin/env bash
# clang-tidy on the sources that changed since a commit:  tests/architecture/tidy.sh [COMMIT | --all]
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
base=${1:-HEAD~1}

if [[ $base == --all ]]; then
    mapfile -t files < <(git ls-files 'runtime/*.cpp' 'physics/*.cpp' 'render/*.cpp' 'samples/*.cpp' 'tests/*.cpp')
elif git rev-parse -q --verify "$base^{commit}" >/dev/null; then
    mapfile -t files < <(git diff --name-only --diff-filter=d "$base" -- '*.cpp')
else
    echo "tidy: no commit $base here, nothing to compare with" >&2
    exit 0
fi
((${#files[@]})) || exit 0
# A large change is sampled, so that CI stays short; --all looks at every file.
max=40
if [[ $base != --all && ${#files[@]} -gt $max ]]; then
    echo "tidy: $max of ${#files[@]} changed files" >&2
    mapfile -t files < <(printf '%s\n' "${files[@]}" | awk -v n="${#files[@]}" -v m=$max 'int(NR * m / n) > int((NR - 1) * m / n)')
fi

# clang reads no precompiled headers of g++: a build folder of its own, configured and never built.
cmake --preset tidy >/dev/null
echo "tidy: ${#files[@]} files" >&2
printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -n 4 clang-tidy -p build/tidy --quiet
