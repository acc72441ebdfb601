#!/usr/bin/env perl
# commas.pl FILE...: where C++ joins statements by a comma, as `a = 1, b = 2;`. Each is printed with its file and
# line. Declarations, arguments, the heads of loops and the lists that follow Eigen's << are no statements.
use strict;
use warnings;

# A statement without what stands before it, as `if (...)`, `else` and labels; $p is a pair of
# parentheses with all in it.
my $p;
$p = qr/\((?:[^()]|(??{ $p }))*\)/;
my $head = qr/(?:(?:if|for|while|switch)(?: constexpr)? ?$p|else\b|do\b|(?:case [\w:]+|default|public|private) ?:(?!:))/;

# Whether a comma joins statements in this one; whatever is in brackets becomes a ~.
sub joined {
  my ($statement) = @_;
  $statement =~ s/\s+/ /g;
  1 while $statement =~ s/^ ?$head//;
  1 while $statement =~ s/\([^()]*\)|\[[^][]*\]|\{[^{}]*\}/~/g;
  1 while $statement =~ s/<[\w:,* &.+~]*>//g;
  return 0 unless $statement =~ /,/;
  return 0 if $statement =~ /^ ?(?!return\b|throw\b)[\w:]+(?: \w+)*[ *&]+\w+ ?(?:[=,~]|$)/;    # TYPE NAME
  return 0 if $statement =~ /^ ?(?:template|using|friend|const|auto)\b/;
  return 0 if $statement =~ /^[^,=]*[^,=<]<<[^<]/;    # Eigen's list
  return 1;
}

for my $file (@ARGV) {
  open(my $in, '<', $file) or die "$file: $!\n";
  local $_ = do { local $/; <$in> };
  my $blank = sub { my $lines = $_[0] =~ tr/\n//; '""' . "\n" x $lines };
  s{//[^\n]*|/\*.*?\*/|^\h*#(?:[^\n]*\\\n)*[^\n]*|R"(\w*)\((?:.*?)\)\1"|"(?:[^"\\\n]|\\.)*"|(?<![\da-fA-F])'(?:[^'\\]|\\.)+'}
   {my $text = $&; $text =~ m{^["'R]} ? $blank->($text) : "\n" x ($text =~ tr/\n//)}gmse;

  # The statements that are open: a block within parentheses, a lambda's, has statements of its own.
  my ($line, @open) = (1, { text => '' });
  for my $token (split /([{};\n])/) {
    my $now = $open[-1];
    if ($token eq "\n") {
      ++$line;
      $now->{text} .= ' ';
    } elsif ($token eq '{') {
      my $list = $now->{text} =~ /(?:[=(,?:]|\breturn|[\w>\]]) *$/ && $now->{text} !~ /(?:\b(?:namespace|struct|class|enum|union|else|do|try)\b[^;=()]*|\) *(?:const|noexcept|override|mutable)|\] *|-> *[\w:<>]+) *$/;
      push @open, { text => '', list => $list };
    } elsif ($token eq '}') {
      my $inner = pop @open if @open > 1;
      my $outer = $open[-1];
      if ($inner && $inner->{list}) {
        $outer->{text} .= '{}';
      } elsif ($outer->{text} =~ /\] *(?:\([^()]*(?:$p[^()]*)*\))? *(?:mutable)? *(?:-> *[\w:<>]+)? *$/) {
        $outer->{text} .= '{}';    # a lambda
      } else {
        $outer->{text} = '';
      }
    } elsif ($token eq ';' && (() = $now->{text} =~ /\(/g) == (() = $now->{text} =~ /\)/g)) {
      (my $shown = $now->{text}) =~ s/^\s+//;
      print "$file:$line: $shown;\n" if joined($now->{text});
      $now->{text} = '';
    } else {
      $now->{text} .= $token;
    }
  }
}
