// Holds a widget of a dock that may be taller than the room there is.
#pragma once

#include <QScrollArea>

namespace usar::widgets {

/// Where the content's least height does not fit, it scrolls; the window never grows for it. As wide as the
/// content's minimumSizeHint at least, so that it scrolls up and down only, unless its layout needs more than that.
/// Takes no focus: the keys are the content's. GUI thread.
class ScrollBox : public QScrollArea {
    Q_OBJECT
public:
    static constexpr int least_px = 72; ///< lowest height: that of three lines

    /// Becomes the parent of `content`, which has all the room as long as that is enough.
    explicit ScrollBox(QWidget* content, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Gives the content the room of the box or, if that is too little, its least size.
    void fit();
    /// Lowest height of the content at this width.
    int leastHeight_px(int width_px) const;
};

} // namespace usar::widgets
