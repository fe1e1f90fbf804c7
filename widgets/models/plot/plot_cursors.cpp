#include "widgets/models/plot/plot_cursors.h"

#include <cmath>

namespace usar::widgets {

void PlotCursors::place(CursorName name, double time_s) {
    (name == CursorName::A ? a_s : b_s) = time_s;
    active = name;
}

bool PlotCursors::move(double by_s) {
    if (!active)
        return false;
    place(*active, *at_s(*active) + by_s);
    return true;
}

bool PlotCursors::remove() {
    if (!active)
        return false;
    (*active == CursorName::A ? a_s : b_s).reset();
    active = a_s ? std::optional(CursorName::A) : b_s ? std::optional(CursorName::B) : std::nullopt;
    return true;
}

std::optional<CursorName> PlotCursors::near(double time_s, double reach_s) const {
    std::optional<CursorName> nearest;
    for (const CursorName name : {CursorName::A, CursorName::B})
        if (const std::optional<double>& at = at_s(name); at && std::abs(*at - time_s) <= reach_s) {
            reach_s = std::abs(*at - time_s);
            nearest = name;
        }
    return nearest;
}

std::optional<double> PlotCursors::difference_s() const {
    return a_s && b_s ? std::optional(*b_s - *a_s) : std::nullopt;
}

CursorRow cursorRow(const SampleHistory& samples, const PlotCursors& cursors) {
    CursorRow row;
    if (cursors.a_s)
        row.a = samples.at(*cursors.a_s);
    if (cursors.b_s)
        row.b = samples.at(*cursors.b_s);
    if (!row.a || !row.b)
        return row;
    row.difference = row.b->value - row.a->value;
    if (const double span_s = *cursors.difference_s(); span_s != 0.0)
        row.slope_per_s = *row.difference / span_s;
    return row;
}

} // namespace usar::widgets
