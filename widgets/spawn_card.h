// The small card beside a start pose: which robot, under which name, with which behavior.
#pragma once

#include <vector>

#include <QComboBox>
#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "core/agent/robot_plugin.h"

namespace usar::widgets {

/// What the person wants to have where.
struct SpawnChoice {
    int start_pose = 0;
    QString class_name; ///< on the wire: "USARBot.AirRobot"
    QString robot_name;
    QString behavior_id; ///< may be empty: no behavior
    bool operator==(const SpawnChoice&) const = default;
};

/// A child sheet, not a popup window, so that the second click of a double-click still reaches the map. Escape, a click
/// elsewhere or a robot spawned elsewhere closes it, and the focus goes back to the map; Return spawns. The choice is
/// remembered for the next pose. GUI thread.
class SpawnCard : public QFrame {
    Q_OBJECT
public:
    explicit SpawnCard(QWidget* over);

    /// What can be spawned, with the behaviors that plugins have for it; the class that is chosen stays so if it is
    /// among them. Keeps no pointer into the list.
    void setRobots(const std::vector<agent::RobotDescription>& robots);
    /// As if the person had chosen it; an unknown one changes nothing.
    void chooseClass(const QString& class_name);
    /// The behavior that is set up: chosen where the class has it.
    void preferBehavior(const QString& id);
    /// Beside `at` (global), within the widget that it lies over.
    void openFor(int start_pose, const QString& pose_name, const QString& robot_name, const QPoint& at);
    /// As the card stands now, valid or not.
    SpawnChoice choice() const;
    /// What a double-click spawns: the choice last made, with this pose and name.
    SpawnChoice lastChoice(int start_pose, const QString& robot_name) const;

signals:
    /// The name is one that the wire can carry.
    void spawnRequested(const usar::widgets::SpawnChoice& choice);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void listBehaviors();
    void spawn();

    /// What the class box lists, row by row.
    std::vector<agent::RobotDescription> robots_;
    QString preferred_behavior_;
    int start_pose_ = 0;
    QLabel* title_;
    QComboBox* class_;
    QLineEdit* name_;
    QComboBox* behavior_;
    QPushButton* spawn_;
};

} // namespace usar::widgets
