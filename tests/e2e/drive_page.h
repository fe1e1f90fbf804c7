// What a person does to drive a robot in the window, and what then goes over the wire.
#pragma once

#include <optional>

#include <QComboBox>
#include <QDockWidget>
#include <QTimer>

#include "tests/e2e/window_page.h"

/// A window with one robot on level enough ground, its wire being listened to.
class DrivePage : public WindowPage {
public:
    explicit DrivePage(const WindowSetup& setup = {}) : WindowPage(setup) {
        QObject::connect(&window().control(), &usar::app::MissionControl::robotUpdated, &window(),
                         [this](usar::RobotId robot, const auto& update) {
                             const int id = robot.value;
                             for (const usar::mission::SentCommand& command : update->commands)
                                 if (usar::protocol::isDrive(command.command)) {
                                     drives_[id] << QString::fromStdString(command.text);
                                     causes_[id] << QString::fromStdString(toText(command.cause.source));
                                 }
                             pressAgainAfterAStall(id);
                         });
    }

    bool spawnClass(const QString& class_name, const std::string& start = "PlayerStart", int id = 1) {
        clickStartPose(start);
        auto* const card = window().views().spawn_card;
        if (!QTest::qWaitFor([&] { return card->isVisible(); }))
            return false;
        card->findChild<QComboBox*>()->setCurrentText(class_name);
        press("Spawn");
        return QTest::qWaitFor([&] { return robot(id) && robot(id)->figures.spawned; }, soon_ms);
    }
    void openDock() {
        auto* const dock = window().findChild<QDockWidget*>("drive");
        dock->show();
        dock->raise();
    }
    /// By its key, and until the robot is known well enough to be driven.
    bool takeControl() {
        pressKey(Qt::Key_G);
        return QTest::qWaitFor([this] { return panel().state().taken && panel().state().axes.any(); }, soon_ms);
    }
    void hold(Qt::Key key) {
        held_ = key;
        QTest::keyPress(window().windowHandle(), key);
    }
    void release(Qt::Key key) {
        held_.reset();
        QTest::keyRelease(window().windowHandle(), key);
    }

    usar::widgets::DrivePanel& panel() { return *window().views().drive; }
    QString control() { return window().views().driver->text(); }
    const usar::mission::ControlState& state(int id = 1) { return robot(id)->figures.control; }
    QString lastDrive(int id = 1) const { return drives_.value(id).isEmpty() ? QString() : drives_.value(id).last(); }
    QString lastCause(int id = 1) const { return causes_.value(id).isEmpty() ? QString() : causes_.value(id).last(); }
    qsizetype driveCount(int id = 1) const { return drives_.value(id).size(); }
    /// Whether the newest DRIVE moves nothing.
    bool standsStill(int id = 1) const {
        QString terms = lastDrive(id).remove(" {Normalized false}").remove(" {Normalized true}");
        return !terms.isEmpty() && !terms.contains(QRegularExpression("[1-9]"));
    }
    usar::Vec3 position_m(int id = 1) {
        return robot(id)->base_in_map ? robot(id)->base_in_map->position_m : usar::Vec3::Zero();
    }
    /// Keeps the key down until the robot has gone that far; false where it did not in time.
    bool driveBy(Qt::Key key, double way_m) {
        const usar::Vec3 from_m = position_m();
        hold(key);
        return QTest::qWaitFor([&] { return (position_m() - from_m).norm() > way_m; }, soon_ms);
    }

private:
    /// On a machine with too much to do the window may say nothing of a held key for so long that the robot is stopped.
    /// A person then presses the key again.
    void pressAgainAfterAStall(int id) {
        const usar::mission::ControlState& now = state(id);
        if (!held_ || now.held || now.last_stop != "nothing was heard from the input device")
            return;
        QTimer::singleShot(0, &window(), [this, key = *held_] {
            if (held_ != key)
                return;
            release(key);
            hold(key);
        });
    }

    std::optional<Qt::Key> held_;
    QMap<int, QStringList> drives_;
    QMap<int, QStringList> causes_;
};
