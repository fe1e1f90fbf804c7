// Chip that says in a word and a shape who drives a robot: nobody, its behavior, or the user.
#pragma once

#include <QWidget>

#include "widgets/models/robot_list_model.h"
#include "widgets/style/form_parts.h"

namespace usar::widgets {

/// A chip that is always visible and can be clicked. The text is elided if there is no room; the tooltip has all of it.
/// GUI thread.
class ControlBadge : public QWidget {
    Q_OBJECT
public:
    explicit ControlBadge(QWidget* parent = nullptr);

    /// Shows who drives; the same words again cost nothing.
    void setWords(const ControlWords& words);
    /// The whole text, "R1: you drive · keys", even if it is elided on the screen.
    QString text() const;
    /// Omits the robot's name and lets the chip take all the width there is.
    void setBare(bool bare);
    /// Asks for a width that has room for a behavior's name.
    void setRoomy(bool roomy);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// By the mouse, Space or Return.
    void clicked();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    ControlWords words_;
    StateDot* dot_ = new StateDot(this);
    bool bare_ = false;
    bool roomy_ = false;
};

} // namespace usar::widgets
