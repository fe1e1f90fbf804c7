// The dock that drives a robot by hand: who has it, a pad, how fast, what is sent and what the robot does.
#pragma once

#include <array>
#include <optional>

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

#include "core/base/stick.h"
#include "widgets/control_badge.h"

namespace usar::widgets {

class DrivePad;
class ElidedLabel;
class EmptyState;

/// How the robot moves, by its own frame; what it does not tell is absent.
struct BodyVelocity {
    std::optional<double> forward_m_s{};
    std::optional<double> left_m_s{};
    std::optional<double> up_m_s{};
    std::optional<double> turn_rad_s{};
    bool operator==(const BodyVelocity&) const = default;
};

/// What there is to drive, and who drives it.
struct DriveState {
    QString robot{}; ///< "R1"; empty: none that could move
    ControlWords control{};
    bool can_take = false; ///< control can be taken, or given back
    bool taken = false;    ///< a hand has it
    StickAxes axes{};
    Stick asked{};                         ///< by whatever hand holds
    Stick sent{};                          ///< that is on its way
    std::optional<double> top_speed_m_s{}; ///< at the whole stick
    QString note{};                        ///< what is missing, or why the last hold ended
    bool note_is_trouble = false;
    bool operator==(const DriveState&) const = default;
};

/// State in, wishes out. While nothing can be driven it says why; the stop button is always there,
/// and off where there is nothing to stop. GUI thread.
class DrivePanel : public QWidget {
    Q_OBJECT
public:
    explicit DrivePanel(QWidget* parent = nullptr);

    void setState(const DriveState& state);
    const DriveState& state() const { return state_; }
    /// Instead of the controls: what is missing and what to do. An empty title ends it.
    void setEmpty(const QString& title, const QString& hint);
    void setVelocity(const BodyVelocity& velocity, bool stale);
    /// The newest DRIVE as it is on the wire.
    void setEcho(const QString& line);
    QString echo() const;
    /// What the row about gamepads says.
    void setGamepad(const QString& text);
    QString gamepadText() const;

    /// What pad and sliders ask together.
    Stick stick() const;
    /// 0..1 of the robot's most.
    double speedShare() const;
    void setSpeedShare(double share);
    void letGo();

signals:
    void takeRequested(bool take);
    void stopRequested();
    void moved(const usar::Stick& stick);
    void speedShareChanged(double share);

private:
    void makePads();
    void makeSpeed();
    void makeFigures();
    void showAxes();
    void showFigures();
    void showSpeed();
    void tellMoved();

    DriveState state_;
    BodyVelocity velocity_;
    bool velocity_stale_ = false;
    bool shown_ = false;                        ///< some state
    QString empty_title_ = QStringLiteral("?"); ///< differs from any real title, so that the first call takes effect
    QWidget* content_;
    EmptyState* empty_;
    ControlBadge* badge_;
    QPushButton* take_;
    DrivePad* pad_;
    DrivePad* side_;
    DrivePad* lift_;
    QSlider* speed_;
    QLabel* speed_text_;
    struct FigureRow {
        QLabel* name = nullptr;
        QLabel* sent = nullptr;
        QLabel* measured = nullptr;
    };
    std::array<FigureRow, 4> figures_; ///< forward, sideways, up, turn
    ElidedLabel* echo_;
    ElidedLabel* gamepad_;
    QLabel* note_;
    QPushButton* stop_;
};

} // namespace usar::widgets
