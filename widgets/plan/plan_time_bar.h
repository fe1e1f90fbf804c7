// Slider that shows which moment of a plan's run is displayed, with buttons to go to other moments.
#pragma once

#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "widgets/models/plan/plan_time.h"

namespace usar::widgets {

/// Shows the state it is given and reports wishes by signals. While the user drags the slider it follows the mouse, not
/// the state. The buttons belong to commands. GUI thread.
class PlanTimeBar : public QWidget {
    Q_OBJECT
public:
    explicit PlanTimeBar(QWidget* parent = nullptr);

    /// Sets the actions of the buttons, which must outlive the bar.
    void setActions(QAction* halt, QAction* back, QAction* forward, QAction* look_back, QAction* live);
    /// Shows this moment; emits nothing.
    void setTime(const PlanTime& time);
    const PlanTime& time() const { return time_; }
    QSlider* slider() const { return slider_; }

signals:
    /// The user wants to see this moment, on the protocol clock.
    void timeWanted(usar::Seconds time);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();
    /// The moment at a value of the slider.
    Seconds timeOf(int value) const;

    PlanTime time_;
    QToolButton* halt_;
    QToolButton* back_;
    QToolButton* forward_;
    QToolButton* look_back_; ///< labeled while the bar shows the past
    QToolButton* live_;
    QSlider* slider_;
    QLabel* words_;
};

/// "live, 80.1 s", "at 12.4 s of 80.1 s, epoch 1 of 3"; empty while there is no cycle.
QString planTimeText(const PlanTime& time);

} // namespace usar::widgets
