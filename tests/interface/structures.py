"""structures.py LANGUAGE FILE: the structures and the numbers of words in thermoroll.h, thermoroll.f90 or the
Python module, a line for each member and word. The Python module has no words for models and statuses."""

import re
import sys

BYTES = {"uint32_t": "i4", "int32_t": "i4", "double": "f8", "integer": "i4", "real": "f8", "u4": "i4"}


def numbered(names):
    number = -1
    for name, _, value in (name.lower().partition("=") for name in re.split(r",\s*", names.strip())):
        number = int(value) if value else number + 1
        yield "word", name.strip().replace("thermoroll_", ""), number


def c(text):
    text = re.sub(r"//.*", "", text)
    for names in re.findall(r"enum \w+ \{(.*?)\};", text, re.S):
        yield from numbered(names)
    for name, body in re.findall(r"struct thermoroll_(\w+) \{(.*?)\};", text, re.S):
        for kind, members in re.findall(r"(?:struct )?(\w+) ([^;]+);", body):
            for member in re.split(r",\s*", members.strip()):
                yield name, re.sub(r"\[256\]", "", member), BYTES.get(kind, kind.replace("thermoroll_", ""))


def fortran(text):
    names = ", ".join(re.findall(r"enumerator :: (.*)", text))
    for row in re.split(r", (?=\w+ = )", names):
        yield from numbered(row)
    for name, body in re.findall(r"type, bind\(c\) :: thermoroll_(\w+)\n(.*?)end type", text, re.S):
        for kind, members in re.findall(r"(\w+(?:\([^)]*\))?) :: (.*)", body):
            of = re.match(r"type\(thermoroll_(\w+)\)", kind)
            kind = of[1] if of else kind.split("(")[0].replace("character", "char")
            for member in members.split(", "):
                yield name, member.replace("(256)", ""), BYTES.get(kind, kind)


def python(text):
    for names in re.findall(r'^    "\w+": \(("\w.*)\),', text, re.M):
        models = re.search(r"^_models = \((.*)\)", text, re.M)[1]
        names = names.replace("*_models", models).replace('"', "").replace("-", "_")
        yield from numbered(names)
    for name, body in re.findall(r"^_(scene|values|units|physical|result|point|law_info|law_value) = (.*?)(?=^_|^\n)", text, re.S | re.M):
        for line in re.findall(r'"((?:\w+ \w+, )*\w+ \w+)"', body):
            for member in line.split(", "):
                label, kind = member.split()
                yield name, label, BYTES.get(kind, kind.replace("S256", "char"))
        for label, kind in re.findall(r'\("(\w+)", (\S+)\)', body):
            yield name, label, kind.strip('_"').replace("S256", "char")


rows = list(globals()[sys.argv[1]](open(sys.argv[2]).read()))
for row in sorted(rows, key=lambda row: row[0]):
    print(*row)
