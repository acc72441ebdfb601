#!/usr/bin/env bash
# No comma joins statements: each stands on a line of its own.
source tests/common.sh

joined() { perl tests/style/commas.pl "$@"; }

found=$(joined src/*/*.?pp src/*/*/*.?pp tests/*.?pp tests/*/*.?pp)
[ -z "$found" ] || fail "$found"

# Each line that is marked is found, and no other.
cat >"$work/mistaken.cpp" <<'END'
void joined(double* x, int n) {
  double a = 1, b = f(a, 2);
  a = 2, b = 3;  // found
  f(a, b), g(b);  // found
  ++a, b += a;  // found
  if (n > 1) a = b, b = 1;  // found
  for (int i = 0, k = 1; i < n; ++i, ++k) x[i] = k;
  for (int i = 0; i < n; ++i) x[i] = 1, a += b;  // found
  else a = std::max(a, b), b = 0;  // found
  const std::map<std::string, double> known{{"a, b = c", 1}, {"d", ','}};
  const auto lambda = [&](double y, double z) {
    a = y, b = z;  // found
    return std::pair<double, double>{y, z};
  };
  std::sort(x, x + n, [](double y, double z) { return y < z; });
  std::for_each(x, x + n, [&](double y) { a = y, b = y; });  // found
  vector << 1, 2, 3;
  return a = 1, b;  // found
}
struct Derived : Base<int, 3>, Other {
  Derived(int n, int m) : Base(n), m_{m} { m_ = 1, n_ = 2; }  // found
  int m_ = 1, n_ = 2;
};
enum class Colour { red = 1, green = 2 };
template <class A, class B> using Both = std::pair<A, B>;
END
awk '/found$/ { print NR }' "$work/mistaken.cpp" >"$work/marked"
joined "$work/mistaken.cpp" | sed -E 's/.*mistaken\.cpp:([0-9]+):.*/\1/' | diff "$work/marked" - || fail "not those that are marked"
