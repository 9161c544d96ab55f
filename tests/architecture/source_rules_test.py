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

    def test_a_long_line(self):
        self.assertEqual(self.faults('a.frag', 'void main() {}\n// ' + 'x' * 118 + '\n'), [(2, 'column')])

    def test_a_refused_word(self):
        for word in ('p' + 'icture', 'kM' + 'ostBodies', 'the tr' + 'uth', 'BodiesA' + 'Step', 'l' + 'amps', '3.14' + '159'):
            self.assertEqual(self.faults('notes.md', f'One line.\nThis is {word} here.\n'), [(2, 'word')], word)
            self.assertEqual(self.faults('CHANGELOG.md', f'This is {word} here.\n'), [], word)
        self.assertEqual(self.faults('notes.md', 'a clamped stamp, the clamp of a caption\n'), [])

    def test_a_long_function_is_counted_from_its_first_line(self):
        body = 'int f(int x) {\n' + '    ++x;\n' * 58 + '    return x;\n}\n'
        self.assertEqual(self.faults('a.cpp', body), [(1, 'function')])
        self.assertEqual(self.faults('a.cpp', body.replace('    ++x;\n', '', 1)), [])

    def test_a_long_file(self):
        self.assertEqual(self.faults('a.cpp', 'int x;\n' * 501), [(501, 'file')])

    def test_a_class_with_too_many_public_methods(self):
        methods = '\n    '.join(f'int f{i}();  ///< one of many' for i in range(26))
        self.assertEqual(self.faults('a.h', HEADER.format(method=methods)), [(4, 'class')])

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
