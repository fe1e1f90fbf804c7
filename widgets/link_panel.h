// What went over the link, counted: lines, bytes, and what went wrong.
#pragma once

#include <vector>

#include <QFrame>
#include <QLabel>

#include "core/protocol/traffic_counts.h"

namespace usar::widgets {

/// Of one connection, since it was made. `not_shown` lines were read, but not put into views.
struct LinkFigures {
    protocol::TrafficCounts counts;
    protocol::TrafficRates rates;
    std::uint64_t not_shown = 0;
};

/// "1,234 in · 56 out · 2 unknown · 1 malformed · 0 dropped": for a line below a list.
QString trafficSummary(const protocol::TrafficCounts& counts);
/// "1.5 MB", "240 B": decimal, four characters of number at most.
QString bytesText(double bytes);

/// A table in a popup; each name says by tooltip what it counts. GUI thread.
class LinkPanel : public QFrame {
    Q_OBJECT
public:
    explicit LinkPanel(QWidget* parent = nullptr);

    /// Whose connection it is: "R1".
    void setName(const QString& name);
    void setFigures(const LinkFigures& figures);
    /// Below that widget, until the person clicks elsewhere.
    void openBelow(const QWidget* widget);

private:
    enum Row { LinesIn, LinesOut, BytesIn, BytesOut, Unknown, Malformed, Dropped, Replaced, NotShown, row_count };
    void addRow(Row row, const QString& name, const QString& help);

    QLabel* title_;
    std::vector<QLabel*> totals_;
    std::vector<QLabel*> rates_;
};

} // namespace usar::widgets
