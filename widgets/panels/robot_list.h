// List of the robots: names, what they are doing, battery.
#pragma once

#include <vector>

#include <QListView>
#include <QWidget>

#include "widgets/models/robot_list_model.h"

namespace usar::widgets {

class EmptyState;
class RobotDelegate;

/// State comes in by setters, choices go out by signals; the keys 1-9 belong to the window. GUI thread.
class RobotList : public QWidget {
    Q_OBJECT
public:
    explicit RobotList(QWidget* parent = nullptr);

    /// Updates the robot with this id, or adds it.
    void updateRobot(const RobotRow& robot);
    /// If the robot was selected, its neighbor is selected and robotSelected emitted.
    void removeRobot(RobotId id);
    /// Selects this robot alone, unless it is selected already; emits no robotSelected. An unknown id clears the
    /// selection.
    void selectRobot(RobotId id);
    /// Id of the selected robot; nullopt if none is.
    std::optional<RobotId> selectedRobot() const;
    /// The selected robot and those that were marked with it (Ctrl or Shift with a click, Ctrl+A), from top to bottom.
    /// Commands apply to all of them.
    std::vector<RobotId> chosenRobots() const;
    /// Their names.
    QStringList chosenNames() const;

    const RobotListModel& model() const { return *model_; }
    /// Height of the list at which no robot is hidden, in pixels, if each has so many lines (1 to 3).
    int wholeHeight_px(int lines = 3) const;
    /// The height of at most `most_px` that shows all robots with as many lines as possible; `most_px` if none does.
    int heightWithin_px(int most_px) const;
    EmptyState* emptyState() const { return empty_state_; } ///< It is shown while there is no robot.
    QSize sizeHint() const override { return {260, 220}; }
    QSize minimumSizeHint() const override { return {180, 64}; }

signals:
    /// By mouse or keys, or because the selected robot was removed.
    void robotSelected(usar::RobotId id);
    /// `chosenRobots` may have changed.
    void chosenChanged();
    /// A robot came or went, so that the list needs another height.
    void wholeHeightChanged();
    /// From the context menu or by Delete; the list itself removes nothing before `removeRobot` is called.
    void removeRequested(usar::RobotId id);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void updateEmptyState();
    /// Marks the selected robot, which Ctrl and a click had unmarked.
    void markSelected();
    /// Gives the rows as many lines as let all robots be seen, but at least one.
    void fitRows();

    RobotListModel* model_ = new RobotListModel(this);
    QListView* view_ = new QListView(this);
    RobotDelegate* delegate_;
    EmptyState* empty_state_;
    bool quiet_ = false; ///< the program changes the selection, not the user
};

} // namespace usar::widgets
