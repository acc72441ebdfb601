// Tangled from paper/15-speed-and-accuracy.md; edit there.
#pragma once

#include "thermoroll/published_scheme.hpp"

namespace thermoroll {

/// What stands for the kernel between a node and a point: its value there, as in the paper, or its
/// mean under the node's hat function, @eq:under-hat.
enum class NodeKernel { sample, mean };

/// The published scheme with tabulated kernels and nothing computed twice. With NodeKernel::sample
/// the results are those of solve_published to rounding. Throws std::invalid_argument for a scene,
/// a traction or options out of range, or options.heaviside_at_zero other than zero.
PublishedSolution solve_cached(const Scene& scene, double traction, Formulation formulation,
                               NodeKernel kernel, const PublishedOptions& options = {});

/// The largest temperature at the collocation points, with the kernel M sampled or averaged.
PublishedPeak cached_max_temperature(const PublishedSolution& solution, double peclet,
                                     NodeKernel kernel);

}  // namespace thermoroll
