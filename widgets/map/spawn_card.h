// The card beside a start pose on which the user chooses a robot, its name and its behavior.
#pragma once

#include <vector>

#include <QComboBox>
#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "core/agent/robot_plugin.h"
#include "widgets/map/spawn_choice.h"

namespace usar::widgets {

/// A child widget, not a popup window, so that the second click of a double-click still reaches the map. Escape, a
/// click elsewhere or a robot spawned elsewhere closes it and returns the focus to the map; Return spawns. The choice
/// is kept for the next pose. GUI thread.
class SpawnCard : public QFrame {
    Q_OBJECT
public:
    /// `over` becomes the parent.
    explicit SpawnCard(QWidget* over);

    /// Sets the classes that can be spawned, with the behaviors that plugins offer for each; the chosen class stays if
    /// it is among them. Stores a copy.
    void setRobots(const std::vector<agent::RobotDescription>& robots);
    /// `present` of at most `most` robots are there. The card says so, and spawns none beyond that.
    void setRoom(int present, int most);
    /// Chooses the class as if the user had done it; an unknown class changes nothing.
    void chooseClass(const QString& class_name);
    /// Chooses this behavior now and for other classes that have it; it is the one that is set up in the behavior
    /// panel.
    void preferBehavior(const QString& id);
    /// Opens the card beside `at` (global coordinates), within its parent.
    void openFor(int start_pose, const QString& pose_name, const QString& robot_name, const QPoint& at);
    /// The choice as shown, even if the name is invalid.
    SpawnChoice choice() const { return lastChoice(start_pose_, name_->text()); }
    /// The choice for a double-click: the class and behavior chosen last, with this pose and name.
    SpawnChoice lastChoice(int start_pose, const QString& robot_name) const;
    /// Shows class, behavior and, while the card is open, the name; emits nothing. What is not offered stays as it is.
    void setChoice(const SpawnChoice& choice);

signals:
    /// The user has chosen a class or a behavior, or typed into the name.
    void choiceEdited(const usar::widgets::SpawnChoice& before, const usar::widgets::SpawnChoice& after);
    /// The name is valid in the protocol.
    void spawnRequested(const usar::widgets::SpawnChoice& choice);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Offers the behaviors of the chosen class, and "None" as the last entry.
    void listBehaviors();
    void takeNeededSize(); ///< makes all words whole
    /// Moves the upper left corner there, or as near as the map allows.
    void place(const QPoint& corner);
    /// True if a robot can be spawned: the name is valid, and there is room for one more.
    bool ready() const { return name_->hasAcceptableInput() && !full_; }
    /// Emits choiceEdited.
    void tellEdit();
    /// Closes the card and emits spawnRequested, if it is ready.
    void spawn();

    /// Entries of the class box, in its order.
    std::vector<agent::RobotDescription> robots_;
    QString preferred_behavior_;
    SpawnChoice told_; ///< what the user saw before an edit
    int start_pose_ = 0;
    bool full_ = false; ///< the greatest number of robots is reached
    QLabel* title_ = new QLabel(this);
    QComboBox* class_ = new QComboBox(this);
    QLineEdit* name_ = new QLineEdit(this);
    QComboBox* behavior_ = new QComboBox(this);
    QLabel* room_ = nullptr; ///< "Robot 4 of 9"
    QPushButton* spawn_ = new QPushButton(tr("Spawn"), this);
};

} // namespace usar::widgets
