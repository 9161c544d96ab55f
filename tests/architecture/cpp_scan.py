"""Reads C++ and GLSL well enough to count: functions with their lines, docstrings and access, and classes.

A scanner, not a parser: it walks over braces and semicolons of the text without comments and strings. It relies on
clang-format's layout nowhere but for finding the comment above a declaration.
"""

import re
from dataclasses import dataclass

_COMMENT_OR_STRING = re.compile(
    r'//(?:\\\n|[^\n])*|/\*.*?\*/|R"([^()\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?:(?<=u8)|(?<![0-9a-fA-F]))\'(?:\\.|[^\'\\\n])+\'',
    re.S)
_PREPROCESSOR = re.compile(r'^[ \t]*#(?:[^\n]*\\\n)*[^\n]*', re.M)
_TOKEN = re.compile(r'[{};]|\b(?:public|private|protected)\s*:(?!:)')
_CLASS = re.compile(r'\b(?:class|struct|union)\s+(?:\[\[[^\]]*\]\]\s*)?(?:\w+\s+)?(?!final\b)(\w[\w:<>, ]*?)\s*(?:\bfinal\s*)?(?::(?!:).*)?$', re.S)
_ALIGNAS = re.compile(r'\balignas\s*\((?:[^()]|\([^()]*\))*\)\s*')
_LAMBDA = re.compile(r'(\w+)\s*=\s*\[[^\]]*\]\s*(?:\(.*\))?[^=()]*$', re.S)
_NOT_FUNCTIONS = re.compile(r'^(?:using|typedef|static_assert|friend|return|if|for|while|switch|do|else|case|default|goto|throw|'
                            r'layout|precision|public|private|protected)\b')
_POINTER_MEMBER = re.compile(r'\(\s*\*\s*(\w+)\s*\)\s*\(')
_NAME = re.compile(r'(operator\s*(?:\(\s*\)|\[\s*\]|[^\s\w(]+|\w+)|~?\w+)\s*(?:<[^()]*>)?\s*\(')


@dataclass
class Function:
    """A declaration or definition; lines count from 1."""
    name: str
    owner: str  # the class, or '' at namespace scope
    first_line: int
    last_line: int
    is_definition: bool
    is_public: bool
    is_documented: bool
    is_exempt: bool  # from docstrings: defaulted, deleted, destructor, operator, override


@dataclass
class Class:
    name: str
    line: int
    public_methods: int = 0


def blank(text):
    """The text with comments, strings and preprocessor lines as spaces; every other character keeps its place. Of branches
    of #if that open different braces, and of #if 0, only what is compiled by default is left."""
    def spaces(match):
        return re.sub(r'[^\n]', ' ', match.group(0))
    return _PREPROCESSOR.sub(spaces, _one_branch(blank_comments(text)))


def blank_comments(text):
    """The text with comments and strings as spaces."""
    return _COMMENT_OR_STRING.sub(lambda match: re.sub(r'[^\n]', ' ', match.group(0)), text)


def _one_branch(text):
    """Blanks #if 0, and the later branches of an #if whose first one leaves braces open, so that braces match."""
    lines, stack = text.split('\n'), []  # for each #if: braces opened so far in its first branch, whether lines are dropped
    for i, line in enumerate(lines):
        directive = re.match(r'\s*#\s*(ifdef|ifndef|if|else|elif|endif)\b\s*(\w*)', line)
        if not directive:
            if any(dropped for _, dropped in stack):
                lines[i] = ' ' * len(line)
            elif stack:
                for level in stack:
                    level[0] += line.count('{') - line.count('}')
        elif directive.group(1).startswith('if'):
            stack.append([0, directive.group(1) == 'if' and directive.group(2) == '0'])
        elif directive.group(1) == 'endif':
            stack = stack[:-1]
        elif stack:
            stack[-1][1] = stack[-1][0] != 0
    return '\n'.join(lines)


def _strip_template(statement):
    """Without a leading template<...> and requires clause, attributes and export macros."""
    statement = statement.strip()
    while statement.startswith('template'):
        depth = 0
        for i, c in enumerate(statement):
            depth += (c == '<') - (c == '>')
            if c == '>' and depth == 0:
                break
        statement = re.sub(r'^requires\s+[\w:<>,\s]+?(?=\b(?:auto|void|bool|int|const|static|inline|constexpr|\w+\s+\w+\()\b)', '',
                           statement[i + 1:].strip())
    return re.sub(r'^\[\[[^\]]*\]\]\s*', '', statement)


def _function_name(statement):
    """The name a statement declares as a function (or C function pointer member), or None."""
    statement, before = _strip_template(statement), None
    while statement != before and 'operator' not in statement:
        statement, before = re.sub(r'<[^<>]*>', '', statement), statement  # template arguments, from the innermost out
    if '(' not in statement or _NOT_FUNCTIONS.match(statement):
        return None
    pointer = _POINTER_MEMBER.search(statement)
    if pointer:
        return pointer.group(1)
    head = statement[:statement.index('(')] if 'operator' not in statement else ''
    if '=' in head or re.search(r'\b(?:class|struct|union|enum|namespace)\s+\w+\s*$', head):
        return None
    match = _NAME.search(statement)
    if not match:
        return None
    name = match.group(1)
    before = statement[:match.start()].strip()
    if re.match(r'^(?:decltype|alignas|sizeof|noexcept|__attribute__|explicit|requires)$', name):
        instead = 'T' if name == 'decltype' else ''  # a type, or nothing
        return _function_name(re.sub(r'\b' + name + r'\s*\([^()]*(?:\([^()]*\)[^()]*)*\)', instead, statement, count=1))
    return name if before or name[0].isupper() or name.startswith('~') or name.startswith('operator') else None


def _is_documented(lines, first, last):
    """A /// or C comment ends directly above line `first`, or ///< stands on a line of the declaration (from 0)."""
    above = lines[first - 1].strip() if first else ''
    if above.startswith('///') and not above.startswith('///<') or above.endswith('*/'):
        return True
    return any('///<' in line or '/*' in line for line in lines[first:last + 1])


def scan(text):
    """All functions and classes of a file, in order."""
    plain, lines = blank(text), text.split('\n')
    starts = [0]
    for line in lines:
        starts.append(starts[-1] + len(line) + 1)

    def line_of(position):
        low, high = 0, len(starts) - 1
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if starts[middle] <= position else (low, middle)
        return low

    functions, classes = [], []
    stack = [('namespace', None, True)]  # kind, object, access is public
    begin = 0
    for token in _TOKEN.finditer(plain):
        kind, owner, is_public = stack[-1]
        symbol, statement = token.group(0), plain[begin:token.start()]
        if symbol == '}':
            closed = stack.pop() if len(stack) > 1 else stack[0]
            if closed[0] == 'function' and closed[1]:
                closed[1].last_line = line_of(token.start()) + 1
            # An initialiser in braces goes on; a body does not.
            begin = begin if closed[0] == 'value' else token.end()
            continue
        if symbol not in '{;':
            if kind == 'class':
                stack[-1] = (kind, owner, symbol.startswith('public'))
                begin = token.end()
            continue
        stripped = statement.strip()
        open_parentheses = statement.count('(') > statement.count(')')
        if symbol == '{' and (open_parentheses or kind == 'value'):
            stack.append(('value', None, False))  # a braced default argument, or braces within braces
            continue
        if open_parentheses:
            continue
        entered = ('block', None, False)
        if kind in ('namespace', 'class'):
            name = _function_name(stripped)
            bare = _ALIGNAS.sub('', _strip_template(stripped))
            if symbol == '{' and re.match(r'^(?:inline\s+)?namespace\b|^extern\s*$', bare):
                entered = ('namespace', None, True)
            elif symbol == '{' and re.search(r'\benum\b', bare) and '(' not in bare:
                entered = ('value', None, False)
            elif symbol == '{' and _CLASS.search(bare) and not (name and '(' in bare.split(':')[0]):
                made = Class(_CLASS.search(bare).group(1).strip(), line_of(begin + len(statement) - len(statement.lstrip())) + 1)
                classes.append(made)
                entered = ('class', made, not re.search(r'\bclass\b', bare))
            elif name and not (symbol == '{' and re.search(r'[\w)]\s*:\s.*[\w>]$', bare, re.S) and _is_member_initialiser(plain, token.start())):
                first = line_of(begin + len(statement) - len(statement.lstrip()))
                last = line_of(token.start())
                tail = stripped[stripped.rfind(')'):]
                class_name = owner.name.split('<')[0] if kind == 'class' else ''
                exempt = bool(re.search(r'=\s*(?:default|delete)\b|\boverride\b|\bfinal\b', tail)
                              or name.startswith(('~', 'operator')))
                made = Function(name, class_name, first + 1, last + 1, symbol == '{', is_public,
                                _is_documented(lines, first, last), exempt)
                functions.append(made)
                is_special = name == class_name or name.startswith(('~', 'operator')) or _POINTER_MEMBER.search(stripped)
                if kind == 'class' and is_public and not is_special:
                    owner.public_methods += 1
                entered = ('function', made, False)
            elif symbol == '{' and kind == 'namespace' and _LAMBDA.search(bare):
                first = line_of(begin + len(statement) - len(statement.lstrip()))
                made = Function(_LAMBDA.search(bare).group(1), '', first + 1, first + 1, True, False, False, True)
                functions.append(made)
                entered = ('function', made, False)
            elif symbol == '{':
                entered = ('value', None, False)
        if symbol == '{':
            stack.append(entered)
            if entered[0] == 'value':
                continue
        begin = token.end()
    return functions, classes


def _is_member_initialiser(plain, position):
    """Whether this brace belongs to a member in a constructor's list (`: m_a{1}, m_b{2} {`), not to its body."""
    depth = 0
    for i in range(position, len(plain)):
        depth += (plain[i] == '{') - (plain[i] == '}')
        if depth == 0:
            return bool(re.match(r'\s*[,{]', plain[i + 1:i + 200]))
    return False
