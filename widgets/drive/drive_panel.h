// The dock for driving a robot by hand: who is in control, the pad, the speed, what is sent and what the robot does.
#pragma once

#include <array>
#include <optional>

#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

#include "core/base/stick.h"
#include "widgets/drive/control_badge.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/form_parts.h"

namespace usar::widgets {

class DrivePad;

/// Measured velocity of the robot in its own frame; nullopt for what it does not report.
struct BodyVelocity {
    std::optional<double> forward_m_s{};
    std::optional<double> left_m_s{};
    std::optional<double> up_m_s{};
    std::optional<double> turn_rad_s{}; ///< counter-clockwise
    bool operator==(const BodyVelocity&) const = default;
};

/// The robot that can be driven, and the state of its manual control.
struct DriveState {
    QString robot{}; ///< "R1"; empty: no robot that can move
    ControlWords control{};
    bool can_take = false; ///< the user can take control or give it back
    bool taken = false;    ///< the user is in control
    /// The axes that the robot can follow; controls of the others are hidden.
    StickAxes axes{};
    Stick asked{};                         ///< by the pad, keys or gamepad
    Stick sent{};                          ///< on its way to the robot
    std::optional<double> top_speed_m_s{}; ///< at full stick and full speed share; nullopt: unknown
    QString note{};                        ///< says what is missing, or why manual control ended
    bool note_is_trouble = false;          ///< shows the note as a warning
    bool operator==(const DriveState&) const = default;
};

/// Shows the state it is given and reports wishes by signals. While nothing can be driven it says why; the stop button
/// is always visible, and disabled if there is nothing to stop. GUI thread.
class DrivePanel : public QWidget {
    Q_OBJECT
public:
    explicit DrivePanel(QWidget* parent = nullptr);

    /// Shows this state; emits nothing.
    void setState(const DriveState& state);
    /// The state as last set.
    const DriveState& state() const { return state_; }
    /// Replaces the controls by a sheet that says what is missing and what to do. An empty title shows the controls
    /// again.
    void setEmpty(const QString& title, const QString& hint);
    /// `stale`: the values may be out of date and are drawn muted.
    void setVelocity(const BodyVelocity& velocity, bool stale);
    /// The newest DRIVE command as it went over the wire; empty: nothing sent yet.
    void setEcho(const QString& line);
    /// The shown text.
    QString echo() const { return echo_->text(); }
    /// Text of the row about gamepads.
    void setGamepad(const QString& text);
    /// The shown text.
    QString gamepadText() const { return gamepad_->text(); }

    /// The combined position of pad and sliders.
    Stick stick() const;
    /// Share 0..1 of the robot's top speed.
    double speedShare() const;
    /// Moves the speed slider.
    void setSpeedShare(double share);
    /// Releases pad and sliders.
    void letGo();

signals:
    /// True: take control, false: give it back.
    void takeRequested(bool take);
    /// The stop button was pressed.
    void stopRequested();
    /// Pad or sliders moved; all zero when they are released.
    void moved(const usar::Stick& stick);
    /// Share 0..1; by the slider or by setSpeedShare.
    void speedShareChanged(double share);

private:
    /// Makes the round pad for driving and turning, and the sliders for sideways and vertical motion.
    void makePads();
    /// Makes the slider for the speed share.
    void makeSpeed();
    /// Makes a row for each axis, and below them the echo, the note and the row about gamepads.
    void makeFigures();
    /// Shows only what the robot's axes allow.
    void showAxes();
    /// Shows what is sent in percent, and what is measured in m/s and degrees per second; a dash is unknown.
    void showFigures();
    /// Shows the speed share in percent, and in m/s if the robot's top speed is known.
    void showSpeed();

    DriveState state_;
    BodyVelocity velocity_;
    bool velocity_stale_ = false;
    QString empty_title_ = QStringLiteral("?"); ///< differs from any real title, so the first setEmpty takes effect
    QWidget* content_ = new QWidget(this);
    EmptyState* empty_ = new EmptyState(content_);
    ControlBadge* badge_ = new ControlBadge(content_);
    QPushButton* take_ = new QPushButton(content_);
    DrivePad* pad_;
    DrivePad* side_;
    DrivePad* lift_;
    QSlider* speed_ = new QSlider(Qt::Horizontal, content_);
    QLabel* speed_text_ = new QLabel(content_);
    /// Labels of one axis: its name, the share that is sent, and the measured velocity.
    struct FigureRow {
        QLabel* name = nullptr;
        QLabel* sent = nullptr;
        QLabel* measured = nullptr;
    };
    std::array<FigureRow, 4> figures_; ///< forward, sideways, up, turn
    ElidedLabel* echo_ = new ElidedLabel(content_);
    ElidedLabel* gamepad_ = new ElidedLabel(content_);
    QLabel* note_ = new QLabel(content_);
    QPushButton* stop_;
};

} // namespace usar::widgets
