#include "widgets/style/scroll_box.h"

#include <algorithm>

#include <QEvent>
#include <QLayout>
#include <QStyle>

namespace usar::widgets {

ScrollBox::ScrollBox(QWidget* content, QWidget* parent) : QScrollArea(parent) {
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setWidget(content);
}

QSize ScrollBox::sizeHint() const {
    constexpr int usual_px = 260; // A dock that is opened must not squeeze its neighbors.
    const QSize content = widget()->sizeHint();
    return {std::max(content.width(), minimumSizeHint().width()), std::clamp(content.height(), least_px, usual_px)};
}

QSize ScrollBox::minimumSizeHint() const {
    const QSize content = widget()->minimumSizeHint();
    const int bar_px = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
    return {content.width() + bar_px, std::min(content.height(), least_px)};
}

int ScrollBox::leastHeight_px(int width_px) const {
    const QLayout* const layout = widget()->layout();
    if (!layout)
        return widget()->minimumSizeHint().height();
    return layout->hasHeightForWidth() ? layout->totalMinimumHeightForWidth(width_px)
                                       : layout->totalMinimumSize().height();
}

// Qt's own way would ask for the preferred height of texts that wrap, and so scroll where nothing needs it.
void ScrollBox::fit() {
    QSize room = maximumViewportSize();
    if (leastHeight_px(room.width()) > room.height())
        room.rwidth() -= style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
    const QLayout* const layout = widget()->layout();
    const QSize least((layout ? layout->totalMinimumSize() : widget()->minimumSizeHint()).width(),
                      leastHeight_px(room.width()));
    widget()->resize(room.expandedTo(least));
}

void ScrollBox::resizeEvent(QResizeEvent* event) {
    fit();
    QScrollArea::resizeEvent(event);
}

bool ScrollBox::eventFilter(QObject* watched, QEvent* event) {
    if (watched == widget() && event->type() == QEvent::LayoutRequest)
        fit();
    return QScrollArea::eventFilter(watched, event);
}

} // namespace usar::widgets
