// The strip of first steps above the map: says what to do next and ticks off what is done.
#pragma once

#include <vector>

#include <QFrame>
#include <QLabel>

namespace usar::widgets {

/// Shows each step with its number, or with a tick once it is done. It can be dismissed at any time; its owner
/// remembers that. GUI thread.
class HintStrip : public QFrame {
    Q_OBJECT
public:
    explicit HintStrip(QWidget* parent = nullptr);

    /// The three steps of the program: spawn a robot, draw the area, press Start.
    static QStringList firstSteps();
    /// Replaces the steps; all count as not done.
    void setSteps(const QStringList& steps);
    /// `step` counts from 0 and must exist.
    void setDone(int step, bool done);
    bool done(int step) const { return done_[static_cast<std::size_t>(step)]; }
    /// Also true if there are no steps.
    bool allDone() const;

signals:
    /// The user hid the strip; the owner should remember that across restarts.
    void dismissed();

private:
    /// Renders the text from steps and state.
    void refresh();

    QStringList steps_;
    std::vector<bool> done_;
    QLabel* text_ = new QLabel(this);
};

} // namespace usar::widgets
