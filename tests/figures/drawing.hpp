#pragma once
#include <string>
#include <vector>

namespace thermoroll_test {

/// What tests/figures/expected/ declares of a figure and its SVG does not show, a line each;
/// nothing when the picture is that of the data in build/data.
///
/// axes.csv has each axis of each panel: its scale, and the values at its ends.
///
/// curves.csv has each curve in the order of drawing: the rows (`where`) and columns of the data
/// that it shows. `mark` says how: line, points, both, thinned (points that stand for all near
/// them), area, rule (a dashed line that is no curve), contour (z at the levels given), cells and
/// map (z as a colour), hatch, text (words at a point; z is how far from it, in letters). `dash` is
/// full or dashed where a caption or a label tells curves by it.
///
/// labels.csv has every text but the tics', in the order of drawing, and what it names: the x, y or
/// colour scale, the heading, a curve (the nearest of those that are named, or the one that a grey
/// line leads to), a key (a sample left of it looks as the curve), cells (a sample of their
/// colour), a level (of the contour on which it stands), or nothing; a text is drawn as a curve.
std::vector<std::string> wrong_in(const std::string& figure, const std::string& svg);

}  // namespace thermoroll_test
