// Who drives a robot, in a word and a shape: nobody, its behavior, or the person.
#pragma once

#include <QToolButton>
#include <QWidget>

#include "widgets/state_dot.h"

namespace usar::widgets {

enum class Driver { Nobody, Behavior, Person };

/// "R1", Person, "keys": what the chip says.
struct ControlWords {
    QString robot{}; ///< empty: no robot is selected
    Driver driver = Driver::Nobody;
    QString by{}; ///< the behavior's name, or what the person holds; may be empty
    bool operator==(const ControlWords&) const = default;
};

/// "Nobody drives", "Terrain survey drives", "You drive · keys".
QString controlText(const ControlWords& words);

/// A chip that is always in sight; a click is `clicked`. The text is elided where there is no room; the tooltip has it
/// whole. GUI thread.
class ControlBadge : public QWidget {
    Q_OBJECT
public:
    explicit ControlBadge(QWidget* parent = nullptr);

    void setWords(const ControlWords& words);
    /// "R1: you drive · keys".
    QString text() const;
    /// Without the robot's name, and as wide as there is room.
    void setBare(bool bare);
    /// Where there is room for a behavior's name, too.
    void setRoomy(bool roomy);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void clicked();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    ControlWords words_;
    StateDot* dot_;
    bool bare_ = false;
    bool roomy_ = false;
};

} // namespace usar::widgets
