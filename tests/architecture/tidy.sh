#!/usr/bin/env bash
# clang-tidy on the sources that changed since a commit:  tests/architecture/tidy.sh [COMMIT | --all]
# COMMIT is HEAD~1 if it is not given. A changed header is looked at through one source that includes it.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
usage="usage: tests/architecture/tidy.sh [COMMIT | --all]"
(($# <= 1)) || { echo "$usage" >&2; exit 2; }

files=()
if [[ ${1:-} == --all ]]; then
    mapfile -d '' -t files < <(git ls-files -z -- 'runtime/*.cpp' 'physics/*.cpp' 'render/*.cpp' 'samples/*.cpp' 'tests/*.cpp')
elif git rev-parse -q --verify "${1:-HEAD~1}^{commit}" >/dev/null; then
    mapfile -d '' -t files < <(git diff -z --name-only --diff-filter=d "${1:-HEAD~1}" -- '*.cpp'
                               git ls-files -z --others --exclude-standard -- '*.cpp')
    mapfile -d '' -t headers < <(git diff -z --name-only --diff-filter=d "${1:-HEAD~1}" -- '*.h')
    for header in "${headers[@]}"; do
        mapfile -t users < <(git grep -lF "#include \"$header\"" -- '*.cpp')
        files+=("${users[@]:0:1}")
    done
elif (($# == 0)); then
    echo "tidy: the first commit has none before it to compare with" >&2
    exit 0
else
    printf 'tidy: expected a commit or --all, found "%s"\n%s\n' "$1" "$usage" >&2
    exit 2
fi
((${#files[@]})) || exit 0
# samples/hosts/untested needs engines that are not here.
mapfile -d '' -t files < <(printf '%s\0' "${files[@]}" | grep -zv '^samples/hosts/untested/' | sort -zu)
((${#files[@]})) || exit 0

# A large change is sampled, so that CI stays short; --all looks at every file.
max=40
if [[ ${1:-} != --all && ${#files[@]} -gt $max ]]; then
    echo "tidy: $max of ${#files[@]} changed files" >&2
    sampled=()
    for ((i = 0; i < max; ++i)); do sampled+=("${files[i * ${#files[@]} / max]}"); done
    files=("${sampled[@]}")
fi

# clang reads no precompiled headers of g++: a build folder of its own, configured and never built.
cmake --preset tidy >/dev/null
echo "tidy: ${#files[@]} files" >&2
printf '%s\0' "${files[@]}" | xargs -0 -P "$(nproc)" -n 4 clang-tidy -p build/tidy --quiet
