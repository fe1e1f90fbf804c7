// Bars around the drawing of a running plan: the moment of the run that is displayed, and where and why it is halted.
#pragma once

#include <QBoxLayout>
#include <QFrame>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "widgets/models/plan/plan_activity.h"

namespace usar::widgets {

/// A slider and buttons to go to other moments. Shows the state it is given and reports wishes by signals. While the
/// user drags the slider it follows the mouse, not the state. The buttons belong to commands. GUI thread.
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
    Seconds timeOf(int value) const { return time_.begin + (time_.end - time_.begin) * (double(value) / run_steps); }

    static constexpr int run_steps = 10000; ///< steps of the slider over the whole run

    PlanTime time_;
    QToolButton* halt_;
    QToolButton* back_;
    QToolButton* forward_;
    QToolButton* look_back_; ///< labeled while the bar shows the past
    QToolButton* live_;
    QSlider* slider_;
    QLabel* words_;
};

/// "live, 80.1 s", "at 12.4 s of 80.1 s, decision 1 of 3"; empty while there is no cycle.
QString planTimeText(const PlanTime& time);

/// Says that a plan is halted, where and why, with buttons to continue. Hidden while there is nothing to say. The
/// buttons belong to commands. GUI thread.
class PlanHaltBar : public QFrame {
    Q_OBJECT
public:
    explicit PlanHaltBar(QWidget* parent = nullptr);

    /// Makes a button for each action; the actions must outlive the bar.
    void setActions(const QList<QAction*>& actions);
    /// Shows a sentence; empty hides the bar.
    void setText(const QString& text);
    QString text() const { return text_->text(); }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QBoxLayout* column_;
    QLabel* text_;
    QBoxLayout* buttons_;
};

} // namespace usar::widgets
