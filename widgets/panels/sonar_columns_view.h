// Instrument that shows each sonar as a column, with the risk zones drawn into it (thesis 4.2).
#pragma once

#include "widgets/models/ranges.h"
#include "widgets/style/sheet.h"

namespace usar::widgets {

/// The height of a column is its reading; the zones are bands at its foot with a line at each threshold. Risk is shown
/// by color, word and shape. GUI thread.
class SonarColumnsView : public Instrument {
    Q_OBJECT
public:
    explicit SonarColumnsView(QWidget* parent = nullptr);

    /// Replaces all columns, which then count as fresh.
    void setColumns(const std::vector<SonarColumn>& columns);
    void setZones(const agent::SonarZones& zones) { setColumns(sonarColumns(zones)); }
    void clear() { setColumns({}); }
    const std::vector<SonarColumn>& columns() const { return columns_; }
    QSize sizeHint() const override { return {280, 150}; }
    QSize minimumSizeHint() const override { return {200, 90}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// Paints the reading on top, the column, its name and the word for its risk, all within `cell`.
    void paintColumn(QPainter& painter, const SonarColumn& column, const QRectF& cell) const;
    /// Paints the bands from the foot of the column up to each threshold, in the column's scale.
    void paintZones(QPainter& painter, const SonarColumn& column, const QRectF& shaft) const;

    std::vector<SonarColumn> columns_;
};

} // namespace usar::widgets
