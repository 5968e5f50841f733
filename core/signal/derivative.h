#pragma once

#include <span>

namespace marey {

/// First derivative per second by central differences, one-sided ones of second order at the ends (Winter, Biomechanics and
/// Motor Control of Human Movement). Both spans have the same length. Not a number where a sample that it needs is not
/// finite; 0 for curves of 1 sample.
void compute_first_derivative(std::span<const double> curve, double rate_hz, std::span<double> result);

/// Second derivative per second squared, in the same way; 0 for curves of fewer than 3 samples.
void compute_second_derivative(std::span<const double> curve, double rate_hz, std::span<double> result);

}  // namespace marey
