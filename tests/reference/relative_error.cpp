#include "tests/reference/relative_error.h"

#include <algorithm>
#include <cassert>

namespace rubble::reference {

double relativeError(const FloatImage& reference, const FloatImage& test, double droppedShare) {
    assert(reference.size == test.size);
    std::vector<double> errors;
    for (size_t i = 0; i < reference.pixels.size(); ++i) {
        double sum = 0.0;
        for (int c = 0; c < 3; ++c) {
            const double expected = reference.pixels[i][c], off = test.pixels[i][c] - expected;
            sum += off * off / (expected * expected + 0.01);
        }
        errors.push_back(sum / 3.0);
    }
    std::sort(errors.begin(), errors.end());
    const size_t kept = errors.size() - size_t(droppedShare * double(errors.size()));
    double sum = 0.0;
    for (size_t i = 0; i < kept; ++i) sum += errors[i];
    return sum / double(std::max<size_t>(kept, 1));
}

}  // namespace rubble::reference
