// The tour of the window: five steps of a first flight, each at the part of the window that it is about.
#pragma once

#include <functional>
#include <vector>

#include <QPointer>
#include <QTimer>

#include "widgets/bars/tour_card.h"
#include "widgets/window/window_views.h"

namespace usar::widgets {

/// A step ends when the person has done it, or by Next. Escape or Leave ends the tour at any moment; Escape keeps its
/// meaning for STOP ALL. Nothing is blocked meanwhile. GUI thread; the views must outlive the tour.
class Tour : public QObject {
    Q_OBJECT
public:
    Tour(QMainWindow& window, const WindowViews& views);

    /// Shows the first step; again: from the beginning.
    void begin();
    /// Ends it at any moment.
    void leave();
    bool running() const { return step_ < steps_.size(); }
    /// True once the tour has begun; then it is not offered any more.
    bool taken() const { return taken_; }
    void setTaken(bool taken);

    // For tests.
    TourCard& card() { return *card_; }
    const TourRing& ring() const { return *ring_; }

protected:
    /// Escape, and a new size of the window.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Step {
        QString title;
        QString text;
        QDockWidget* dock;             ///< shown and raised first; nullptr: none
        std::function<QRect()> target; ///< what to surround, in the window
        std::function<bool()> done;
    };

    void makeSteps();
    void show(std::size_t step);
    void next();
    /// Follows what moves, and goes on when the step was done.
    void look();
    /// The visible part of a widget, in the window; empty if there is none.
    QRect placeOf(const QWidget* widget) const;
    /// A start pose with its name: one that stands free of others, if there is one.
    QRect startPose() const;
    /// What leads to a start of the behavior: the area if it has none, or else Start.
    QRect wayToStart() const;

    QMainWindow& window_;
    const WindowViews& views_;
    TourRing* ring_;
    TourCard* card_;
    std::vector<Step> steps_;
    std::size_t step_ = 0;
    bool was_done_ = false; ///< when the step began, so that it waits for Next
    bool behavior_chosen_ = false;
    bool taken_ = false;
    QTimer watch_;
    QTimer tick_; ///< the time to see that a step was done
};

} // namespace usar::widgets
