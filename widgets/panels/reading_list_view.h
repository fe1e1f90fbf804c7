// Readings of one kind, one below the other: name, bar in its range, figure with unit.
#pragma once

#include <QStringList>

#include "widgets/models/reading_list.h"
#include "widgets/style/sheet.h"

namespace usar::widgets {

/// As tall as its rows need. A row that has fallen silent while others have not is gray by itself and says its age. A
/// state is a shape and a word, never a color alone. GUI thread.
class ReadingListView : public Instrument {
    Q_OBJECT
public:
    explicit ReadingListView(QWidget* parent = nullptr);

    /// Replaces the rows; the same again cost nothing. `now` tells their ages; `linked`: false while the robot is
    /// silent, so that nothing is fresh.
    void setList(const ReadingList& list, Seconds now, bool linked);
    /// The rows as last set.
    const ReadingList& list() const { return list_; }
    QSize sizeHint() const override { return {280, height_px()}; }
    QSize minimumSizeHint() const override { return {200, height_px()}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int height_px() const;
    int rowHeight_px() const;
    bool rowStale(const ReadingRow& row) const { return stale() || row.heard.stale(now_); }
    void paintRow(QPainter& painter, const ReadingRow& row, const QRectF& box, double name_px) const;
    void paintBar(QPainter& painter, const ReadingRow& row, const QRectF& groove) const;

    ReadingList list_{};
    QStringList words_; ///< of the rows as painted
    Seconds now_{0.0};
};

} // namespace usar::widgets
