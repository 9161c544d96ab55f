#!/usr/bin/env python3
"""The rules of source_rules.py, each broken on purpose in a small tree."""

import tempfile
import unittest
from pathlib import Path

import cpp_scan
import source_rules

HEADER = '''#pragma once
namespace rubble {{
/// Where bodies are.
class World {{
public:
    /// An empty one.
    World();
    ~World();
    World& operator=(const World&) = delete;
    {method}
private:
    void hidden();
    int m_count = 0;
}};
}}  // namespace rubble
'''


class SourceRules(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)

    def faults(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding='utf-8')
        found, _ = source_rules.check(self.root)
        path.unlink()
        return [(line, kind) for _, line, kind, _ in found]

    def test_a_good_header_has_no_faults(self):
        self.assertEqual(self.faults('a.h', HEADER.format(method='/// How many.\n    int count() const { return m_count; }')), [])
        self.assertEqual(self.faults('a.h', HEADER.format(method='int count() const;  ///< how many')), [])

    def test_a_function_without_a_docstring(self):
        self.assertEqual(self.faults('a.h', HEADER.format(method='int count() const;')), [(10, 'docstring')])
        self.assertEqual(self.faults('a.h', '#pragma once\n// Not a docstring.\nfloat lengthOf(float x);\n'), [(3, 'docstring')])
        self.assertEqual(self.faults('a.h', '#pragma once\ntemplate <class T, class U = V<T>>\nT sum(T a, U b = U{1}) {\n    return a + b;\n}\n'),
                         [(2, 'docstring')])

    def test_a_header_that_includes_too_little(self):
        self.assertEqual(self.faults('a.h', '#pragma once\n#include <vector>\nstruct A { std::vector<int> a; std::span<int> b; };\n'),
                         [(3, 'include')])

        commented = '#pragma once\n// #include <vector>\nstruct A { std::vector<int> a; };\n'
        self.assertEqual(self.faults('a.hpp', commented), [(3, 'include')])
        self.assertEqual(self.faults('a.hpp', commented.replace('// #', '#  ')), [])
        self.assertEqual(self.faults('a.h', '#pragma once\nusing namespace std;\n'), [(2, 'include')])

    def test_a_file_with_any_name(self):
        self.assertEqual(self.faults('ünï "cöde".hh', '#pragma once\nfloat lengthOf(float x);\n'), [(2, 'docstring')])

    def test_a_long_line(self):
        self.assertEqual(self.faults('a.frag', 'void main() {}\n// ' + 'x' * 118 + '\n'), [(2, 'column')])

    def test_a_refused_word(self):
        for word in ('p' + 'icture', 'kM' + 'ostBodies', 'the tr' + 'uth', 'BodiesA' + 'Step', 'l' + 'amps', '3.14' + '159'):
            self.assertEqual(self.faults('notes.md', f'One line.\nThis is {word} here.\n'), [(2, 'word')], word)
            self.assertEqual(self.faults('CHANGELOG.md', f'This is {word} here.\n'), [], word)
        self.assertEqual(self.faults('notes.md', 'a clamped stamp, the clamp of a caption, 23.14159\n'), [])

    def test_a_name_that_is_good_english(self):
        self.assertEqual(self.faults('a.cpp', '// F' + 'our bodies fall.\n'), [])
        self.assertEqual(self.faults('a.cpp', 'F' + 'our sum;\n'), [(1, 'word')])

    def test_a_long_function_is_counted_from_its_first_line(self):
        body = 'int f(int x) {\n' + '    ++x;\n' * 58 + '    return x;\n}\n'
        self.assertEqual(self.faults('a.cpp', body), [(1, 'function')])
        self.assertEqual(self.faults('a.cpp', body.replace('    ++x;\n', '', 1)), [])

        for head in ('auto f = [](int x) {\n', 'decltype(auto) f(int x) {\n'):
            end = '};\n' if '=' in head else '}\n'
            self.assertEqual(self.faults('a.cpp', head + '    ++x;\n' * 59 + end), [(1, 'function')])

    def test_what_follows_odd_braces_is_still_looked_at(self):
        for odd in ("constexpr char8_t c = u8'{';", '// goes on \\\n{', '#if 0\n{\n#endif',
                    '#ifdef A\ninline void f(int) {  ///< one\n#else\ninline void f(long) {  ///< other\n#endif\n}'):
            lines = odd.count('\n') + 1
            self.assertEqual(self.faults('a.h', f'{odd}\nfloat lengthOf(float x);\n'), [(lines + 1, 'docstring')], odd)

    def test_a_long_file(self):
        self.assertEqual(self.faults('a.cpp', 'int x;\n' * 501), [(501, 'file')])

    def test_a_class_with_too_many_public_methods(self):
        methods = '\n    '.join(f'int f{i}();  ///< one of many' for i in range(26))
        self.assertEqual(self.faults('a.h', HEADER.format(method=methods)), [(4, 'class')])
        for head in ('alignas(16) World', 'World final'):
            text = HEADER.format(method=methods).replace('class World', 'class ' + head)
            self.assertEqual(self.faults('a.h', text), [(4, 'class')], head)

    def test_a_loop_that_a_software_gl_runs_too_often(self):
        for loop in ('for (int i = 0; i < uCount; ++i) {', 'for (int i = begin; i < 4; ++i) {', 'while (i < uCount) {',
                     'for (int i = 0; i < 4 && isOn; ++i) {', 'while (++i < uCount);'):
            self.assertEqual(self.faults('shaders/lib/a.glsl', f'void f() {{\n    {loop}\n'), [(2, 'loop')], loop)
        for loop in ('for (int i = 0; i < 4; ++i) {', 'for (int i = 1; i < kTaps; ++i) {', 'for (;;) {', 'for (int i = 1;; ++i) {',
                     'do {\n    } while (++i < uCount);', 'for (; i < kMaxSteps; ++i) {'):
            self.assertEqual(self.faults('shaders/lib/a.glsl', f'void f() {{\n    {loop}\n'), [], loop)

    def test_a_loop_over_uniforms_that_is_unrolled(self):
        text = 'uniform vec4 uBoxes[8];\nvoid f() {\n    int i = 0;\n    do {\n        g(uBoxes[i]);\n    } while (++i < uCount);\n}\n'
        self.assertEqual(self.faults('shaders/lib/a.glsl', text), [(2, 'loop')])
        self.assertEqual(self.faults('shaders/lib/a.glsl', text.replace('= 0', '= loopBegin()')), [])
        self.assertEqual(self.faults('shaders/lib/a.glsl', 'uniform vec4 uBoxes[8];\nvoid f() {\n    g(uBoxes[0]);\n}\n'), [])

    def test_a_test_that_is_never_built(self):
        self.assertEqual(self.faults('tests/new/a_test.cpp', 'int x;\n'), [(1, 'test')])

    def test_a_long_decision(self):
        text = '# Light\n\n### Rays are exact\n\n' + 'word ' * 101 + '\n### Another\n\nshort\n'
        self.assertEqual(self.faults('docs/decisions/light.md', text), [(3, 'decision')])

    def test_the_scanner_tells_functions_from_other_braces(self):
        functions, classes = cpp_scan.scan('''
namespace a { namespace { int hidden() { return 1; } } }
enum class Kind { A, B };
struct Point { int x = 0; std::array<int, 2> y{{1, 2}}; void (*call)(int) = nullptr; };
constexpr std::array<const char*, size_t(Kind::B)> kNames = {"a", "b"};
const Table kTable = {{"a", [](int x) { return x; }}};
Point::Point(int a) : x(a), y{{a, a}} {
    if (a) { while (a--) {} }
}
auto later(int x) -> std::vector<int>;
TEST(Group, Name) { EXPECT_EQ(1, 1); }
void* operator new(size_t size) { return nullptr; }
std::string text = "void inString() {";  // void inComment() {
template <typename T> requires std::integral<T> T twice(T x) { return 2 * x; }
''')
        self.assertEqual([f.name for f in functions], ['hidden', 'call', 'Point', 'later', 'TEST', 'operator new', 'twice'])
        self.assertEqual([(c.name, c.public_methods) for c in classes], [('Point', 0)])
        self.assertEqual([(f.first_line, f.last_line) for f in functions if f.name == 'Point'], [(7, 9)])


if __name__ == '__main__':
    unittest.main()
