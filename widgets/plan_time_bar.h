// Where the shown state of a plan stands in its run, and how to get to another moment of it.
#pragma once

#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "widgets/models/plan_time.h"

namespace usar::widgets {

/// Wishes out, state in. While the person drags the slider it follows the hand. Buttons are those of commands. GUI
/// thread.
class PlanTimeBar : public QWidget {
    Q_OBJECT
public:
    explicit PlanTimeBar(QWidget* parent = nullptr);

    void setActions(QAction* halt, QAction* back, QAction* forward, QAction* look_back, QAction* live);
    void setTime(const PlanTime& time);
    const PlanTime& time() const { return time_; }
    QSlider* slider() const { return slider_; }

signals:
    /// By the protocol's clock.
    void timeWanted(usar::Seconds time);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();
    Seconds timeOf(int value) const;

    PlanTime time_;
    QToolButton* halt_;
    QToolButton* back_;
    QToolButton* forward_;
    QToolButton* look_back_; ///< says what it does while the bar stands in the past
    QToolButton* live_;
    QSlider* slider_;
    QLabel* words_;
};

/// "live, 80.1 s", "at 12.4 s of 80.1 s, epoch 1 of 3".
QString planTimeText(const PlanTime& time);

} // namespace usar::widgets
