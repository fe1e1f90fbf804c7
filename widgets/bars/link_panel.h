// Popup with the traffic counters of a link: lines, bytes and errors.
#pragma once

#include <array>

#include <QFrame>
#include <QLabel>

#include "core/protocol/traffic_counts.h"

namespace usar::widgets {

/// Counters of one connection since it was made. `not_shown` lines were read, but not passed to the views.
struct LinkFigures {
    protocol::TrafficCounts counts;
    protocol::TrafficRates rates;
    std::uint64_t not_shown = 0;
};

/// "1,234 in · 56 out · 2 unknown · 1 malformed · 0 dropped": a line below a list.
QString trafficSummary(const protocol::TrafficCounts& counts);
/// "1.5 MB", "240 B": decimal units, at most four characters for the number.
QString bytesText(double bytes);

/// Table with totals and rates per second; the tooltip of each name explains what is counted. GUI thread.
class LinkPanel : public QFrame {
    Q_OBJECT
public:
    explicit LinkPanel(QWidget* parent = nullptr);

    /// Name of the robot whose connection this is: "R1"; empty: none.
    void setName(const QString& name);
    /// Rates are per second of wall time.
    void setFigures(const LinkFigures& figures);
    /// Opens the popup below that widget; a click elsewhere closes it.
    void openBelow(const QWidget* widget);

private:
    static constexpr std::size_t row_count = 9;

    QLabel* title_ = new QLabel(this);
    std::array<QLabel*, row_count> totals_;
    std::array<QLabel*, row_count> rates_;
};

} // namespace usar::widgets
