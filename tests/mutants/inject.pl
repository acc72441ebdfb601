#!/usr/bin/env perl
# inject.pl LIST SOURCES [TARGET]: whether each mutant of the list (its format stands at its top)
# applies to the sources exactly once. With a TARGET, the sources are written there with all mutants
# in them, of which MUTANT=NUMBER in the environment chooses one when the program runs, and standard
# output has a line of each: number, file, tests, reason to be equivalent or -, description.
use strict;
use warnings;

my ($list, $sources, $target) = @ARGV;
my $problems = 0;
sub problem { my ($line, $words) = @_; print STDERR "$list:$line: $words\n"; $problems = 1; }

# --- The list: blocks of lines that begin with a key ----------------------------------------------

my ($file, $block, @mutants) = ({file => '', tests => ''});
open my $in, '<', $list or die "$list: $!\n";
while (my $line = <$in>) {
  next if $line =~ /^(#.*)?$/;
  my ($key, $value) = $line =~ /^(file|tests|mutant|equivalent|-|\+)(?: (.*))?$/;
  if (!$key || ($key ne 'file' && !$block)) { problem($., "not understood: $line"); next; }
  if ($key eq 'file') { $block = $file = {tests => ''}; }
  if ($key eq 'mutant') { push @mutants, $block = {%$file, line => $., number => @mutants + 1}; }
  $block->{$key} = $value // '';
}

# --- Where each applies: a space of the context stands for any white space ------------------------

sub pattern { join '\s+', map { quotemeta } split / +/, $_[0], -1; }

sub text_of {
  open my $source, '<', "$sources/$_[0]" or return '';
  local $/;
  return <$source>;
}

my (%text, %places);
for my $m (@mutants) {
  my $name = $m->{file};
  my ($before, $old, $after) = ($m->{'-'} // '') =~ /^(.*)«(.+)»(.*)$/;
  if (!defined $old || !defined $m->{'+'} || $m->{tests} eq '') {
    problem($m->{line}, 'a mutant needs its tests, a line "- CODE«CODE»CODE" and a line "+ CODE"');
    next;
  }
  if ($old !~ /.;$/ && ($m->{'+'} =~ /^\s*$/ || $old =~ /^([,;:?]|[!=<>&|]=|&&|\|\|)|([,;:?=]|&&|\|\|)$/)) {
    problem($m->{line}, "neither an expression and another, nor statements: $old");
    next;
  }
  $text{$name} //= text_of($name);
  my ($head, $body, $tail, @found) = map { pattern($_) } $before, $old, $after;
  while ($text{$name} =~ /($head)($body)(?=$tail)/g) { push @found, [$-[2], $+[2]]; }
  if (@found != 1) { problem($m->{line}, "stands in $name " . @found . " times: $before$old$after"); next; }
  ($m->{from}, $m->{to}) = @{$found[0]};
  push @{$places{$name}{$m->{from}}}, $m;
}

# --- The sources with the mutants, from the last place to the first; a place may have several -----

for my $name (keys %places) {
  my $end = length $text{$name};
  for my $from (sort { $b <=> $a } keys %{$places{$name}}) {
    my @here = @{$places{$name}{$from}};
    my $to = $here[0]{to};
    for my $m (@here) { problem($m->{line}, 'overlaps another') if $m->{to} != $to || $to > $end; }
    my $code = substr $text{$name}, $from, $to - $from;
    my $statement = $code =~ /;$/;
    for my $m (@here) {
      my $chosen = "mutated($m->{number})";
      $code = $statement ? "if ($chosen) { $m->{'+'} } else $code" : "($chosen ? ($m->{'+'}) : ($code))";
    }
    substr($text{$name}, $from, $to - $from) = $code;
    $end = $from;
  }
}
exit $problems if $problems || !$target;

sub write_text {
  open my $out, '>', "$target/$_[0]" or die "$target/$_[0]: $!\n";
  print $out $_[1];
}
write_text($_, "#include \"mutant.hpp\"\n$text{$_}") for keys %text;
write_text('mutant.hpp', <<'END');
#pragma once
#include <cstdlib>
inline const char* const named_mutant = std::getenv("MUTANT");
inline const int chosen_mutant = named_mutant == nullptr ? 0 : std::atoi(named_mutant);
inline bool mutated(int number) { return number == chosen_mutant; }
END
print join("\t", @$_{'number', 'file', 'tests'}, $_->{equivalent} // '-', $_->{mutant}), "\n" for @mutants;
