#include "widgets/models/plot/sample_history.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace usar::widgets {

namespace {

/// The samples that stand for a digest, in order of time and each once. A gap inside is narrower than a column; only
/// one at the beginning or the end is told.
void appendMarks(std::vector<Sample>& line, const Digest& digest) {
    const auto push = [&](const Sample& sample) {
        const bool again =
            !line.empty() && (line.back() == sample || (line.back().time_s == sample.time_s &&
                                                        std::isnan(line.back().value) && std::isnan(sample.value)));
        if (!again)
            line.push_back(sample);
    };
    push(digest.first);
    if (digest.count > 0) {
        const bool least_first = digest.least.time_s <= digest.most.time_s;
        push(least_first ? digest.least : digest.most);
        push(least_first ? digest.most : digest.least);
    }
    push(digest.last);
}

/// Collects samples and digests, which come in order of time, by columns of equal width.
class ColumnLine {
public:
    ColumnLine(double from_s, double to_s, int columns)
        : from_s_(from_s)
        , width_s_(std::max((to_s - from_s) / std::max(columns, 1), 1e-9)) {}

    bool fitsOneColumn(const Digest& digest) const {
        return columnOf(digest.first.time_s) == columnOf(digest.last.time_s);
    }
    void add(const Digest& digest) {
        const double column = columnOf(digest.first.time_s);
        if (open_.samples > 0 && column != column_)
            close();
        column_ = column;
        open_.append(digest);
    }
    /// For a digest that is wider than a column.
    void addWide(const Digest& digest) {
        close();
        appendMarks(line_, digest);
    }
    std::vector<Sample> take() {
        close();
        return std::move(line_);
    }

private:
    double columnOf(double time_s) const { return std::floor((time_s - from_s_) / width_s_); }
    void close() {
        if (open_.samples > 0)
            appendMarks(line_, open_);
        open_ = {};
    }

    double from_s_;
    double width_s_;
    double column_ = 0.0;
    Digest open_;
    std::vector<Sample> line_;
};

bool overlaps(const Digest& digest, double from_s, double to_s) {
    return digest.last.time_s >= from_s && digest.first.time_s <= to_s;
}

bool lies(const Digest& digest, double from_s, double to_s) {
    return digest.first.time_s >= from_s && digest.last.time_s <= to_s;
}

/// Index of the first one that does not end before `time_s`.
template <class Digests>
std::size_t firstFrom(const Digests& digests, double time_s) {
    const auto found =
        std::ranges::partition_point(digests, [&](const Digest& digest) { return digest.last.time_s < time_s; });
    return static_cast<std::size_t>(found - digests.begin());
}

} // namespace

Digest::Digest(const Sample& only) : first(only), last(only), least(only), most(only), samples(1) {
    count = std::isnan(only.value) ? 0 : 1;
    mean = count > 0 ? only.value : 0.0;
}

void Digest::append(const Digest& later) {
    if (later.samples == 0)
        return;
    if (samples == 0) {
        *this = later;
        return;
    }
    last = later.last;
    samples += later.samples;
    if (later.count == 0)
        return;
    if (count == 0 || later.least.value < least.value)
        least = later.least;
    if (count == 0 || later.most.value > most.value)
        most = later.most;
    const double here = static_cast<double>(count);
    const double there = static_cast<double>(later.count);
    const double apart = later.mean - mean;
    mean += apart * there / (here + there);
    squares += later.squares + apart * apart * here * there / (here + there);
    count += later.count;
}

SampleHistory::SampleHistory(std::size_t exact, std::size_t digests)
    : exact_limit_(std::max<std::size_t>(exact, 1))
    , digest_limit_(std::max<std::size_t>(digests, 2)) {}

void SampleHistory::append(const Sample& sample) {
    if (blocks_.empty() || blocks_.back().samples == block_size)
        blocks_.emplace_back(sample);
    else
        blocks_.back().append(Digest(sample));
    exact_.push_back(sample);
    ++size_;
    if (exact_.size() >= exact_limit_ + block_size)
        retireBlock();
}

void SampleHistory::clear() {
    *this = SampleHistory(exact_limit_, digest_limit_);
}

void SampleHistory::retireBlock() {
    if (old_.size() == old_.capacity()) // Not more memory than the limit allows.
        old_.reserve(std::min(2 * old_.size() + 64, digest_limit_ + 1));
    if (old_.empty() || old_.back().samples >= old_span_ * block_size)
        old_.push_back(blocks_.front());
    else
        old_.back().append(blocks_.front());
    blocks_.pop_front();
    exact_.erase(exact_.begin(), exact_.begin() + static_cast<std::ptrdiff_t>(block_size));
    if (old_.size() > digest_limit_)
        coarsen();
}

void SampleHistory::coarsen() {
    std::vector<Digest> joined;
    joined.reserve(digest_limit_ + 1);
    for (std::size_t i = 0; i < old_.size(); ++i)
        if (i % 2 == 0)
            joined.push_back(old_[i]);
        else
            joined.back().append(old_[i]);
    old_ = std::move(joined);
    old_span_ *= 2;
}

std::vector<Sample> SampleHistory::curve(double from_s, double to_s, int columns) const {
    const std::size_t first_block = std::max<std::size_t>(firstFrom(blocks_, from_s), 1) - 1;
    const auto begin = std::ranges::lower_bound(exact_, from_s, {}, &Sample::time_s);
    const auto end = std::ranges::upper_bound(exact_, to_s, {}, &Sample::time_s);
    const auto before = begin == exact_.begin() ? begin : std::prev(begin);
    const auto after = end == exact_.end() ? end : std::next(end);
    if (before != begin || old_.empty()) // Nothing older is needed.
        if (end - begin <= columns)
            return {before, after};
    ColumnLine line(from_s, to_s, columns);
    const std::size_t first_old = std::max<std::size_t>(firstFrom(old_, from_s), 1) - 1;
    const std::size_t end_old = first_block == 0 ? old_.size() : 0; // Otherwise all of them are left of the edge.
    for (std::size_t i = first_old; i < end_old && (i == 0 || old_[i - 1].first.time_s <= to_s); ++i)
        line.fitsOneColumn(old_[i]) ? line.add(old_[i]) : line.addWide(old_[i]);
    for (std::size_t i = first_block; i < blocks_.size() && (i == 0 || blocks_[i - 1].first.time_s <= to_s); ++i) {
        if (line.fitsOneColumn(blocks_[i])) {
            line.add(blocks_[i]);
            continue;
        }
        const std::size_t stop = std::min((i + 1) * block_size, static_cast<std::size_t>(after - exact_.begin()));
        for (std::size_t s = std::max(i * block_size, static_cast<std::size_t>(before - exact_.begin())); s < stop; ++s)
            line.add(Digest(exact_[s]));
    }
    return line.take();
}

Statistics SampleHistory::statistics(double from_s, double to_s) const {
    Digest all;
    bool exact = true;
    for (std::size_t i = firstFrom(old_, from_s); i < old_.size() && overlaps(old_[i], from_s, to_s); ++i) {
        exact = exact && lies(old_[i], from_s, to_s);
        all.append(old_[i]);
    }
    for (std::size_t i = firstFrom(blocks_, from_s); i < blocks_.size() && overlaps(blocks_[i], from_s, to_s); ++i) {
        if (lies(blocks_[i], from_s, to_s)) {
            all.append(blocks_[i]);
            continue;
        }
        for (std::size_t s = i * block_size; s < std::min((i + 1) * block_size, exact_.size()); ++s)
            if (exact_[s].time_s >= from_s && exact_[s].time_s <= to_s)
                all.append(Digest(exact_[s]));
    }
    const double freedom = all.count > 1 ? static_cast<double>(all.count - 1) : 1.0;
    return {all.count, all.least.value, all.most.value, all.mean, std::sqrt(all.squares / freedom), exact};
}

std::optional<Reading> SampleHistory::at(double time_s) const {
    const auto number = [](double value, bool exact) {
        return std::isnan(value) ? std::nullopt : std::optional(Reading{value, exact});
    };
    if (empty() || time_s < oldest_s())
        return std::nullopt;
    if (time_s >= exactFrom_s())
        return number(std::prev(std::ranges::upper_bound(exact_, time_s, {}, &Sample::time_s))->value, true);
    const auto after = std::ranges::upper_bound(old_, time_s, {}, [](const Digest& each) { return each.first.time_s; });
    const Digest& digest = *std::prev(after);
    if (time_s >= digest.last.time_s)
        return number(digest.last.value, true);
    if (time_s == digest.first.time_s)
        return number(digest.first.value, true);
    return digest.count > 0 ? number(digest.mean, false) : std::nullopt;
}

std::vector<Sample> SampleHistory::knownSamples() const {
    std::vector<Sample> known;
    known.reserve(4 * old_.size() + exact_.size());
    for (const Digest& digest : old_)
        appendMarks(known, digest);
    known.insert(known.end(), exact_.begin(), exact_.end());
    return known;
}

std::size_t SampleHistory::memory_bytes() const {
    return exact_.size() * sizeof(Sample) + (blocks_.size() + old_.capacity()) * sizeof(Digest);
}

} // namespace usar::widgets
