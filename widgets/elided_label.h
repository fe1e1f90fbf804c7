// One line of text that ends in "…" where there is no room, instead of being cut.
#pragma once

#include <QLabel>

namespace usar::widgets {

/// text() stays whole for assistive tools; give it a tooltip with the whole text.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    using QLabel::QLabel;
    QSize minimumSizeHint() const override { return {24, QLabel::minimumSizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace usar::widgets
