// One line of text that ends in "…" where there is no room, instead of being cut.
#pragma once

#include <QLabel>

namespace usar::widgets {

/// `text` as wide as `width_px` allows: whole, or without its last parts (they stand between " · "), or elided.
QString fittedText(const QString& text, const QFontMetrics& metrics, int width_px);

/// text() stays whole for assistive tools; give it a tooltip with the whole text.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    using QLabel::QLabel;
    QSize minimumSizeHint() const override { return {24, QLabel::minimumSizeHint().height()}; }
    QSize sizeHint() const override;
    /// It asks for the width of `text`, whatever it says, so that what stands beside it does not jump.
    void setRoomFor(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString room_for_;
};

} // namespace usar::widgets
