#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace rubble {

/// Bytes of the process that are in physical memory.
size_t residentBytes();

/// What a long run takes, in twelve parts of equal length: prints a line for each, and compares them.
class Steadiness {
public:
    /// steps: in all. unit: what a step is, in the table.
    Steadiness(int steps, std::string unit);
    /// Ends a step. liveBodies: in the world now; 0 where there is none.
    void endStep(size_t liveBodies);
    /// The exit code: 1, with a reason, if the last quarter takes over 5 % more than the second one: memory that is in
    /// use, calls of operator new and bodies in a step, and resident memory by more than 8 MiB as well. timed:
    /// processor time of a step as well.
    int finish(bool timed) const;

private:
    struct Part {
        double milliseconds = 0.0, allocations = 0.0, bodies = 0.0;  ///< means of a step
        double bytes = 0.0, resident = 0.0;                          ///< in use at the end of each step, mean
    };
    Part mean(size_t begin, size_t end) const;

    int m_steps, m_done = 0;
    std::string m_unit;
    std::vector<Part> m_parts;
    Part m_sum;
    double m_start;        ///< processor time when the part began, ms
    size_t m_allocations;  ///< when the part began
};

}  // namespace rubble
