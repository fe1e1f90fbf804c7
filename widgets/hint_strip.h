// The strip of first steps over the map: says what to do next and ticks off what is done.
#pragma once

#include <vector>

#include <QFrame>
#include <QLabel>

namespace usar::widgets {

/// Steps in words, each with its number until it is done and a tick then. When all are done it says so and may be
/// dismissed like before; its owner remembers that. GUI thread.
class HintStrip : public QFrame {
    Q_OBJECT
public:
    explicit HintStrip(QWidget* parent = nullptr);

    /// "Double-click a start pose", "Draw the area", "Press Start": the product's own three.
    static QStringList firstSteps();
    /// Forgets what was done.
    void setSteps(const QStringList& steps);
    /// Steps count from 0.
    void setDone(int step, bool done);
    bool done(int step) const { return done_[static_cast<std::size_t>(step)]; }
    /// True also where there are no steps.
    bool allDone() const;

signals:
    /// Hidden by the person: the owner remembers it over restarts.
    void dismissed();

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    QStringList steps_;
    std::vector<bool> done_;
    QLabel* text_;
};

} // namespace usar::widgets
