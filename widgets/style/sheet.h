// Painting functions of the framed sheet that all painted instruments share.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <QPainter>
#include <QPointF>
#include <QString>
#include <QStyleOptionViewItem>
#include <QWidget>

#include "core/base/clock.h"

namespace usar::widgets {

/// Paints frame and background over the whole widget; leaves antialiasing on.
void paintSheet(QPainter& painter, const QWidget& widget);
/// The same with a sentence that says what will appear here.
void paintEmptySheet(QPainter& painter, const QWidget& widget, const QString& sentence);
/// Paints the name on the left and the newest figure on the right, which is gray if stale.
void paintSheetHead(QPainter& painter, const QWidget& widget, const QString& name, const QString& value, bool stale);
/// Paints the ground in a cross-section: connects neighboring points and fills down to `bottom_px`. An absent point
/// interrupts the line, because nothing is known there. All coordinates are pixels.
void paintGround(QPainter& painter, const std::vector<std::optional<QPointF>>& line, double bottom_px, bool stale);
/// Paints a small note in the drawing on a background of its own, because lines may pass under it. Leaves its pen and
/// font set on the painter.
void paintSheetNote(QPainter& painter, const QPointF& baseline, const QString& text);
/// Top edge of the drawing area below the head, in pixels.
double sheetHead_px(const QWidget& widget);

/// Paints a raised card on which something can be read above a drawing. Leaves its pen and brush set.
void paintCard(QPainter& painter, const QRectF& card);

/// Fills a rectangle in low strips, without antialiasing. Qt 6.4 hands a fill of more than 95 rows to a pool of
/// threads, and waking those costs more than filling.
void fillInStrips(QPainter& painter, const QRectF& rectangle, const QColor& color);

/// The outline of a rectangle, inside of it, filled like that.
void frameInStrips(QPainter& painter, const QRectF& rectangle, double width_px, const QColor& color);

/// Dashes of 2 pixels' width along the edges of a rectangle, as far as they are in `sight`. Those of a dashed pen would
/// move by a pixel with what else is painted at the same time.
void dashFrame(QPainter& painter, const QRectF& rectangle, const QRectF& sight, const QColor& color);
/// Paints the background of a list's row: raised if it is selected, with a frame if it has the focus.
void paintRowGround(QPainter& painter, const QStyleOptionViewItem& option);
/// Paints a line of text at the left of `box`, elided with "…" if there is no room.
void paintElided(QPainter& painter, const QRect& box, const QString& text);
/// `pattern` has the lengths of dashes and gaps in turn, as multiples of `width_px`.
QPen dashedPen(const QColor& color, double width_px, const QList<qreal>& pattern);

/// Base of the painted instruments, whose figures may be out of date. GUI thread.
class Instrument : public QWidget {
public:
    using QWidget::QWidget;
    /// Draws the instrument gray, and texts struck through or with the word "stale", because its figures may be out of
    /// date. `age` is that of the figures; infinite if it is not known. `period`: how often they come; nullopt if that
    /// is not known. Repaints only if what is shown of them changes.
    void setStale(bool stale, Seconds age = Seconds(std::numeric_limits<double>::infinity()),
                  std::optional<Seconds> period = {});
    bool stale() const { return stale_; }
    /// How often the figures come: "5.0 Hz"; empty while they are stale, or if it is not known.
    const QString& rateText() const { return rate_text_; }
    /// The tooltip, with a line on rate and age of the figures if they are known.
    QString toolTipNow() const;

protected:
    /// Repaints with new figures, which are not stale; `description` says them to screen readers.
    void showFresh(const QString& description);
    /// Says the figures to screen readers, which also hear whether they are stale.
    void describe(const QString& words);
    /// Paints the head of the sheet: the name, or "laser (stale, 12 s)"; the rate, if there is room for it; and the
    /// newest figure.
    void paintHead(QPainter& painter, const QString& name, const QString& value = {}) const;
    /// Returns `fresh`, or the color for stale figures.
    QColor ink(const QColor& fresh) const;
    /// Shows toolTipNow() as the tooltip.
    bool event(QEvent* event) override;

private:
    QString headName(const QString& name) const;

    QString description_;
    QString age_text_; ///< empty: not known, or not stale
    QString rate_text_;
    Seconds age_{std::numeric_limits<double>::infinity()};
    bool stale_ = false;
};

} // namespace usar::widgets
