// Choice of the plan that a behavior runs: the one that comes with the robot, or a file of the user's.
#pragma once

#include <map>
#include <string>

#include <QComboBox>
#include <QStringList>
#include <QWidget>

class QToolButton;

namespace usar::widgets {

/// A list of plans with two buttons. Remembers the chosen files of each behavior. GUI thread.
class PlanChoice : public QWidget {
    Q_OBJECT
public:
    explicit PlanChoice(QWidget* parent = nullptr);

    /// Shows the choices of this behavior and selects the built-in plan, called `plan_name`. An empty `plan_name` means
    /// that the behavior has no plan: the widget is hidden. Emits nothing.
    void setBehavior(const std::string& behavior_id, const QString& plan_name);
    /// Selects this file, added to the list if it is new; an empty path selects the built-in plan. Emits nothing.
    void choose(const QString& path);
    /// The chosen file; empty for the built-in plan.
    QString path() const { return box_->currentData().toString(); }
    /// True for a behavior without a plan.
    bool empty() const { return behavior_id_.empty(); }

signals:
    /// By the user; empty for the built-in plan.
    void chosen(const QString& path);
    /// The user wants a file that is not in the list.
    void openRequested();
    /// The user wants to edit the chosen plan.
    void editRequested();

private:
    void addFile(const QString& path);
    QToolButton* addButton(const QString& icon_name, const QString& text, const QString& help);

    QComboBox* box_ = new QComboBox;
    std::string behavior_id_; ///< empty: the behavior has no plan
    /// Chosen files by behavior.
    std::map<std::string, QStringList> paths_;
};

} // namespace usar::widgets
