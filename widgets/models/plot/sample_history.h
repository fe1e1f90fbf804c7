// The samples of one plotted value over hours, in bounded memory, such that no peak is lost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace usar::widgets {

/// One value of a field.
struct Sample {
    double time_s = 0.0; ///< protocol clock
    double value = 0.0;  ///< SI units; NaN for a value that is not a number, which leaves a gap in the line
    bool operator==(const Sample&) const = default;
};

/// What is kept of consecutive samples. `first` and `last` may be NaN; the other figures are those of the numbers.
struct Digest {
    Sample first;
    Sample last;
    Sample least; ///< the first sample with the least value; without meaning while `count` is 0
    Sample most;
    std::uint64_t samples = 0; ///< all samples, also those that are no number
    std::uint64_t count = 0;   ///< the numbers among them
    double mean = 0.0;
    double squares = 0.0; ///< sum of the squared differences to the mean (Welford)

    Digest() = default;
    explicit Digest(const Sample& only);
    /// Appends later samples, by the formulas of Chan, Golub and LeVeque for the union of two samples.
    void append(const Digest& later);
};

/// A value that was read from a history, in SI units.
struct Reading {
    double value = 0.0;
    bool exact = true; ///< false: the mean of the samples around, which are not kept one by one any more
    bool operator==(const Reading&) const = default;
};

/// Figures of a span of time, in SI units.
struct Statistics {
    std::uint64_t count = 0; ///< samples that are numbers; the other figures have no meaning while it is 0
    double least = 0.0;
    double most = 0.0;
    double mean = 0.0;
    double deviation = 0.0; ///< standard deviation of a sample (n - 1); 0 for a single one
    bool exact = true;      ///< false: old samples a little outside of the span were counted, too
};

/// The newest samples are kept one by one. Older ones are kept as digests of equally many samples; each time there are
/// too many digests, neighbors are joined, and the digests become twice as coarse. So every peak remains, with its
/// time.
///
/// Memory: at most (exact + 64) samples of 16 bytes, exact / 64 + digests digests of 96 bytes: 3.9 MB with the
/// defaults, however long the history is. At 10 samples a second the last 3.6 hours are exact. All of them together
/// always show at least digests / 2 = 8192 separate stretches, more than a screen has columns. Plain value.
class SampleHistory {
public:
    static constexpr std::size_t default_exact = 131'072;
    static constexpr std::size_t default_digests = 16'384;
    static constexpr std::size_t block_size = 64; ///< exact samples in a digest of the newest part

    /// `exact`: number of samples that are kept one by one, at least 1; `digests`: at least 2.
    explicit SampleHistory(std::size_t exact = default_exact, std::size_t digests = default_digests);

    /// Times must not decrease.
    void append(const Sample& sample);
    void clear();

    bool empty() const { return exact_.empty(); }
    /// The number of samples that were appended, also of those that are kept in digests.
    std::uint64_t size() const { return size_; }
    /// Only of a history that is not empty.
    double oldest_s() const { return old_.empty() ? exact_.front().time_s : old_.front().first.time_s; }
    double newest_s() const { return exact_.back().time_s; }
    /// From this time on all samples are kept one by one. Only of a history that is not empty.
    double exactFrom_s() const { return exact_.front().time_s; }

    /// A line that looks like the one through all samples if `columns` is the number of pixel columns from `from_s` to
    /// `to_s`: the first, least, highest and last sample of each column, in order of time, and one sample on either
    /// side beyond the edge. Where a screen has room for all samples, these are all samples. NaN is a gap.
    std::vector<Sample> curve(double from_s, double to_s, int columns) const;
    /// Figures of the samples from `from_s` to `to_s`, both included.
    Statistics statistics(double from_s, double to_s) const;
    /// The newest value at this time; nullopt before the first sample, and in a gap.
    std::optional<Reading> at(double time_s) const;
    /// Every sample that is known one by one: those that mark the digests, and all newer ones.
    std::vector<Sample> knownSamples() const;
    /// The bytes that samples and digests take now.
    std::size_t memory_bytes() const;

private:
    /// Moves the oldest exact block into the digests.
    void retireBlock();
    /// Joins neighboring digests.
    void coarsen();

    std::size_t exact_limit_;
    std::size_t digest_limit_;
    std::deque<Sample> exact_;   ///< begins with a whole block
    std::deque<Digest> blocks_;  ///< of exact_, block_size samples each; the last one may have fewer
    std::vector<Digest> old_;    ///< all before exact_; the last one may have fewer samples than the others
    std::uint64_t old_span_ = 1; ///< blocks in each digest of old_
    std::uint64_t size_ = 0;
};

} // namespace usar::widgets
