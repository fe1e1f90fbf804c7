// Label of one line that is elided with "…" instead of being cut off when there is no room.
#pragma once

#include <QLabel>

namespace usar::widgets {

/// Shortens `text` to `width_px`: drops trailing parts (separated by " · ") first, then elides the rest.
QString fittedText(const QString& text, const QFontMetrics& metrics, int width_px);

/// The property `text` remains complete for assistive tools; give the label a tooltip with the complete text.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    using QLabel::QLabel;
    QSize minimumSizeHint() const override { return {24, QLabel::minimumSizeHint().height()}; }
    QSize sizeHint() const override;
    /// Makes the label ask for the width of `text` whatever it shows, so that its neighbors do not move.
    void setRoomFor(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString room_for_;
};

} // namespace usar::widgets
