#!/usr/bin/env bash
# tangle_test.sh CASE: one case of the tangler, run in the project's folder. The cases are the
# functions below that begin with a capital; each writes its own small chapters.
source tests/common.sh
cp paper/tangle.lua "$scratch"
tangler=../tangle.lua # relative, as pandoc takes capitals out of the name of a reader
cd "$work"

# A chapter from stdin.
chapter() { cat >"$1"; }

tangle() { pandoc --preserve-tabs -f "$tangler" -t plain -o /dev/null "$@"; }

# expect_error 'one.md:3: words' CHAPTER...: stops with exactly this message and writes nothing.
expect_error() {
  local message=$1 status=0
  shift
  tangle "$@" 2>errors || status=$?
  [ $status -ne 0 ] || fail "status 0, expected: $message"
  [ "$(cat errors)" = "$message" ] || fail "said: $(cat errors); expected: $message"
  [ ! -e src ] && [ ! -e a.cpp ] || fail "files were written: $(find . -name "*.cpp")"
}

# expect_file FILE: the file is the header line and what stands on stdin.
expect_file() {
  diff <(tail -n +2 "$1") - || fail "$1 differs"
}

MissingChunk() {
  chapter one.md <<'END'
# Title
``` {.cpp file=src/a.cpp}
int before;
  <<nowhere>>
```
END
  expect_error 'one.md:4: missing chunk: <<nowhere>> is nowhere defined' one.md
}

CyclicChunks() {
  chapter one.md <<'END'
``` {.cpp file=src/a.cpp}
<<first>>
```
END
  chapter two.md <<'END'
``` {.cpp #first}
<<second>>
```
``` {.cpp #second}
int x;
<<first>>
```
END
  expect_error \
    'two.md:6: cyclic chunks: src/a.cpp -> first -> second -> first' one.md two.md
}

UnusedChunk() {
  chapter one.md <<'END'
``` {.cpp file=src/a.cpp}
int a;
```

``` {.cpp #forgotten}
int b;
```
END
  expect_error 'one.md:5: unused chunk: <<forgotten>> reaches no file' one.md
}

DoublyFiledChunk() {
  chapter one.md <<'END'
``` {.cpp file=src/a.cpp}
int a;
```
END
  chapter two.md <<'END'
Text.

``` {.cpp #other file=src/a.cpp}
int b;
```
END
  expect_error 'two.md:3: src/a.cpp is already filed at one.md:1' one.md two.md
}

ChunkFiledTwice() {
  chapter one.md <<'END'
``` {.cpp #a file=src/a.cpp}
int a;
```

``` {.cpp #a file=src/b.cpp}
int b;
```
END
  expect_error 'one.md:5: chunk a is already filed as src/a.cpp at one.md:1' one.md
}

# Files are written below TANGLE_ROOT and nowhere else.
FileOutside() {
  local path
  for path in /a.cpp ../a.cpp src/../../a.cpp src/..; do
    printf 'Text.\n\n``` {.cpp #a file=%s}\nint a;\n```\n' "$path" | chapter one.md
    expect_error "one.md:3: $path: a file is named from the project's folder, without .." one.md
  done
  chapter one.md <<'END'
``` {.cpp file=src/a..b.cpp}
int a;
```
END
  tangle one.md
  [ -s src/a..b.cpp ] || fail "two dots in a name were refused"
}

BadReferenceName() {
  local name
  for name in 'a b' '-a' ' a' ''; do
    printf '``` {.cpp file=src/a.cpp}\nint before;\n  <<%s>>\n```\n' "$name" | chapter one.md
    expect_error "one.md:3: bad reference: <<$name>> is not the name of a chunk" one.md
  done
}

BadIndentation() {
  chapter one.md <<'END'
- An item:

  ``` {.cpp file=src/a.cpp}
  int a;
 int b;
  ```
END
  expect_error \
    'one.md:5: bad indentation: this line is less indented than the fence of its chunk' one.md
}

ReferenceInsideText() {
  chapter one.md <<'END'
``` {.cpp file=src/a.cpp}
int a; <<rest>>
```
``` {.cpp #rest}
int b;
```
END
  expect_error 'one.md:2: a reference must stand alone on its line: int a; <<rest>>' one.md
}

UnclosedFence() {
  chapter one.md <<'END'
Text.
``` {.cpp file=src/a.cpp}
int a;
END
  expect_error 'one.md:2: this fence is never closed' one.md
}

UnwritableFolder() {
  chapter one.md <<'END'
``` {.cpp file=src/a.cpp}
int a;
```
END
  echo kept >occupied
  ! TANGLE_ROOT=occupied tangle one.md 2>errors || fail "wrote below a file"
  grep -q '^occupied/src/a.cpp:' errors || fail "said: $(cat errors)"
  [ "$(cat occupied)" = kept ] || fail "the file in the way was changed"
}

Header() {
  chapter 02-b.md <<'END'
``` {.cpp file=src/a.cpp}
<<part>>
```
END
  chapter 01-a.md <<'END'
``` {.cpp #part}
int a;
```
END
  tangle 02-b.md 01-a.md
  [ "$(head -n 1 src/a.cpp)" = \
    "// Tangled from paper/01-a.md, paper/02-b.md; edit there." ] ||
    fail "header: $(head -n 1 src/a.cpp)"

  chapter 03-c.md <<'END'
``` {.python file=src/a.py}
pass
```
``` {.fortran file=src/a.f90}
end
```
END
  tangle 03-c.md
  [ "$(head -n 1 src/a.py) $(head -n 1 src/a.f90)" = \
    "# Tangled from paper/03-c.md; edit there. ! Tangled from paper/03-c.md; edit there." ] ||
    fail "headers: $(head -n 1 src/a.py src/a.f90)"
}

AppendsInOrder() {
  chapter one.md <<'END'
``` {.cpp #list}
int first;
```
``` {.cpp file=src/a.cpp}
<<list>>
int last;
```
``` {.cpp #list}
int second;
```
END
  chapter two.md <<'END'
``` {.cpp #list}
int third;
```
END
  tangle one.md two.md
  expect_file src/a.cpp <<'END'
int first;
int second;
int third;
int last;
END
}

PartsWithTitlesAreApart() {
  chapter one.md <<'END'
``` {.cpp file=src/a.cpp}
<<list>>
```
``` {.cpp #list title="The first"}
int first;
```
``` {.cpp #list title="The second"}
int second;
```
``` {.cpp #list}
int third;
```
END
  tangle one.md
  expect_file src/a.cpp <<'END'
int first;

int second;
int third;
END
}

IndentsReferences() {
  chapter one.md <<'END'
1. In a list the fence is indented, the code is not:

   ``` {.cpp file=src/a.cpp}
   int f() {
     <<body>>
   }
   ```

``` {.cpp #body}
if (true) {
	<<inner>>

}
```

``` {.cpp #inner}
g();

  h();
```
END
  tangle one.md
  printf 'int f() {\n  if (true) {\n  \tg();\n\n  \t  h();\n\n  }\n}\n' | expect_file src/a.cpp
}

LeavesIllustrations() {
  chapter one.md <<'END'
``` {.cpp}
<<not a chunk>> and <<neither>>
```

~~~~ {.markdown}
``` {.cpp #quoted}
<<nowhere>>
```
~~~~

``` sh
cat <<END
```

``` {.cpp file=src/a.cpp}
std::cout << name << std::vector<std::vector<int>>{};
```
END
  tangle one.md
  echo 'std::cout << name << std::vector<std::vector<int>>{};' | expect_file src/a.cpp
}

WritesOnlyWhatChanged() {
  chapter one.md <<'END'
``` {.cpp file=src/a.cpp}
int a;
```
``` {.cpp file=src/b.cpp}
int b;
```
END
  tangle one.md
  touch -d 2001-01-01 src/a.cpp src/b.cpp
  sed -i '1i Prose before.' one.md
  sed -i 's/int b/int c/' one.md
  tangle one.md
  [ "$(date -r src/a.cpp +%Y)" = 2001 ] || fail "an unchanged file was written"
  [ "$(date -r src/b.cpp +%Y)" != 2001 ] || fail "a changed file was not written"
  echo 'int c;' | expect_file src/b.cpp
  [ "$(find src -type f | wc -l)" = 2 ] || fail "left behind: $(find src)"
}

Root() {
  chapter one.md <<'END'
``` {.cpp file=src/deep/a.cpp}
int a;
```
END
  TANGLE_ROOT='the root' tangle one.md
  echo 'int a;' | expect_file 'the root/src/deep/a.cpp'
  [ ! -e src ] || fail "wrote outside TANGLE_ROOT"
}

# Errors before, inside and after an indented reference: the compiler must name the chapter's lines
# and columns, and show them.
CompilerNamesChapter() {
  chapter one.md <<'END'
Some prose.

``` {.cpp file=src/a.cpp}
int before = wrong_before;
int f() {
  <<body>>
  return wrong_after;
}
```

More prose.

``` {.cpp #body}

int inside = wrong_inside;
```
END
  TANGLE_LINES=1 tangle "$PWD/one.md"
  ! LC_ALL=C "${CXX:-c++}" -fsyntax-only src/a.cpp 2>errors || fail "the compiler found no error"
  local place
  for place in 4:14 15:14 7:10; do
    grep -qF "$PWD/one.md:$place: error:" errors || fail "no error at $place: $(cat errors)"
  done
  grep -q 'int inside = wrong_inside;' errors || fail "the chapter's line is not shown: $(cat errors)"
}

"$1"
