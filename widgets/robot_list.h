// The list of robots: who is there, what they do, how much battery they have.
#pragma once

#include <QListView>
#include <QWidget>

#include "widgets/models/robot_list_model.h"

namespace usar::widgets {

class EmptyState;

/// Values in by setters, choices out by signals; keys 1-9 are the window's. GUI thread.
class RobotList : public QWidget {
    Q_OBJECT
public:
    explicit RobotList(QWidget* parent = nullptr);

    /// All there are; the selection stays with its robot.
    void setRobots(const std::vector<RobotRow>& robots);
    /// Adds a robot that is not there yet.
    void updateRobot(const RobotRow& robot);
    /// If it was selected, its neighbor is, and that is told.
    void removeRobot(int id);
    /// Silent; an unknown id selects nobody.
    void selectRobot(int id);
    /// Its id; nothing while nobody is selected.
    std::optional<int> selectedRobot() const;

    const RobotListModel& model() const { return *model_; }
    /// Shown while there is no robot; give it the action that spawns one.
    EmptyState* emptyState() const { return empty_state_; }
    QSize sizeHint() const override { return {260, 220}; }
    QSize minimumSizeHint() const override { return {180, 100}; }

signals:
    /// By mouse or keys, or because the selected robot went away.
    void robotSelected(int id);
    /// From the context menu or by Delete; nothing is removed until `removeRobot`.
    void removeRequested(int id);

private:
    void showMenu(const QPoint& at);
    void requestRemoval();
    void updateEmptyState();

    RobotListModel* model_;
    QListView* view_;
    EmptyState* empty_state_;
    bool quiet_ = false; ///< a change of the selection is ours, not the person's
};

} // namespace usar::widgets
