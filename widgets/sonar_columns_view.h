// Nine columns for the state of the single sonars, with the risk zones drawn into each (thesis 4.2).
#pragma once

#include <QWidget>

#include "widgets/models/sonar_columns.h"

namespace usar::widgets {

/// A column is as high as its reading; the zones are bands at its foot with a line at their thresholds. Risk is color,
/// word and shape. GUI thread.
class SonarColumnsView : public QWidget {
    Q_OBJECT
public:
    explicit SonarColumnsView(QWidget* parent = nullptr);

    /// Replaces all columns and makes them fresh again.
    void setColumns(const std::vector<SonarColumn>& columns);
    void setZones(const agent::SonarZones& zones) { setColumns(sonarColumns(zones)); }
    void clear() { setColumns({}); }
    /// Grey and struck out, until the next columns.
    void setStale(bool stale);
    const std::vector<SonarColumn>& columns() const { return columns_; }
    QSize sizeHint() const override { return {280, 150}; }
    QSize minimumSizeHint() const override { return {200, 90}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// Reading on top, shaft, name, and the word of the risk; `cell` is what the column may use.
    void paintColumn(QPainter& painter, const SonarColumn& column, const QRectF& cell) const;
    /// From the foot of the shaft up to each threshold, in the scale of the column.
    void paintZones(QPainter& painter, const SonarColumn& column, const QRectF& shaft) const;

    std::vector<SonarColumn> columns_;
    bool stale_ = false;
};

} // namespace usar::widgets
