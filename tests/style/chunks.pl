#!/usr/bin/env perl
# chunks.pl CHAPTER...: how the chapters tell their code. It prints one line of numbers and then every
# chunk that stands without a word before it or is too long.
#
# A chunk is a fenced block with a name or a file. It is introduced if a sentence stands between it
# and the chunk or heading before it; titles, tables, captions and lists of tests are no sentences.
# Blank lines do not count. A chunk that is a whole file is assembled, not read: its includes, its
# namespaces and its references are left out of the lengths, but it needs its sentence like any other.
use strict;
use warnings;
use utf8;
use open qw(:std :utf8);

my ($longest, @lengths, @complaints) = (30);
my ($chunks, $silent) = (0, 0);

# Whether a paragraph tells something.
sub tells { return $_[0] !~ /^(#|\*Checked by\*|!\[|:::|: |\||<!--)/ && $_[0] =~ /\p{L}{2}/ }

# The end of a chunk that began at the line with this number, from the chapter.
sub chunk {
  my ($chapter, $number, $attributes, $introduced, $length) = @_;
  my ($name) = $attributes =~ /#(\S+)/;
  my ($file) = $attributes =~ /file=(\S+)/;
  return unless $name || $file;
  $name ||= $file;
  ++$chunks;
  if (!$introduced) {
    ++$silent;
    push @complaints, "$chapter:$number: $name stands without a word before it";
  }
  return if $file;
  push @lengths, $length;
  push @complaints, "$chapter:$number: $name has $length lines" if $length > $longest;
}

for my $chapter (@ARGV) {
  open(my $in, '<', $chapter) or die "$chapter: $!\n";
  my ($fence, $attributes, $begin, $length, $introduced, $paragraph, $table) = ('', '', 0, 0, 0, '', 0);
  my $end_paragraph = sub {
    $introduced = 1 if !$table && tells($paragraph);
    $introduced = 0 if $paragraph =~ /^#/;
    $paragraph = '';
  };
  while (my $line = <$in>) {
    if ($fence) {
      if ($line =~ /^\s*\Q$fence\E\s*$/) {
        chunk($chapter, $begin, $attributes, $introduced, $length);
        ($fence, $introduced) = ('', 0);
      } else {
        ++$length if $line =~ /\S/;
      }
    } elsif ($line =~ /^\s*(```+)\s*(?:\{(.*)\})?\s*\S*$/) {
      $end_paragraph->();
      ($fence, $attributes, $begin, $length) = ($1, $2 // '', $., 0);
    } elsif ($line =~ /^:::/) {
      $end_paragraph->();
      $table = $line =~ /\{/;
    } elsif ($line =~ /^\s*$/) {
      $end_paragraph->();
    } else {
      $paragraph .= $line;
    }
  }
}

die "no chunks found\n" unless @lengths;
@lengths = sort { $a <=> $b } @lengths;
my $at = sub { $lengths[int($_[0] * $#lengths + 0.5)] };
printf "%d chunks, %.1f %% without a word before them; lines: median %d, p90 %d, most %d\n", $chunks,
  100 * $silent / $chunks, $at->(0.5), $at->(0.9), $lengths[-1];
print "$_\n" for @complaints;
