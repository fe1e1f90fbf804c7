// The two cursors of the plots, and what they measure.
#pragma once

#include <optional>

#include "widgets/models/plot/sample_history.h"

namespace usar::widgets {

enum class CursorName { A, B };

/// Times of the cursors on the protocol clock, in seconds. Either may be missing. The active one moves by keys; it is
/// the one that was placed or moved last. Plain value.
struct PlotCursors {
    std::optional<double> a_s{};
    std::optional<double> b_s{};
    std::optional<CursorName> active{};

    const std::optional<double>& at_s(CursorName name) const { return name == CursorName::A ? a_s : b_s; }
    /// Places a cursor and makes it the active one.
    void place(CursorName name, double time_s);
    /// Moves the active cursor by so many seconds; returns false if none is active.
    bool move(double by_s);
    /// Removes the active cursor; the other one, if there is one, becomes active. Returns false if none is active.
    bool remove();
    /// The cursor nearest to this time and not farther than `reach_s`.
    std::optional<CursorName> near(double time_s, double reach_s) const;
    /// B - A; nullopt unless both are set.
    std::optional<double> difference_s() const;
    bool operator==(const PlotCursors&) const = default;
};

/// What the cursors read of one series, in SI units.
struct CursorRow {
    std::optional<Reading> a{}; ///< nullopt without this cursor, before the first sample, and in a gap
    std::optional<Reading> b{};
    std::optional<double> difference{};  ///< b - a; nullopt unless both are there
    std::optional<double> slope_per_s{}; ///< difference by B - A; nullopt also while both are at one time
    bool operator==(const CursorRow&) const = default;
};
CursorRow cursorRow(const SampleHistory& samples, const PlotCursors& cursors);

} // namespace usar::widgets
