// Which plan decides: the one that comes with the robot, or one of a person's own.
#pragma once

#include <map>
#include <string>

#include <QStringList>
#include <QWidget>

class QComboBox;
class QToolButton;

namespace usar::widgets {

/// A list of plans with two buttons. Remembers for each behavior which files were chosen for it. GUI thread.
class PlanChoice : public QWidget {
    Q_OBJECT
public:
    explicit PlanChoice(QWidget* parent = nullptr);

    /// Shows the plan that comes with it; hidden where no plan decides, which has an empty name. Silent.
    void setBehavior(const std::string& behavior_id, const QString& plan_name);
    /// Joins the list if it is new there; an empty path is the robot's own. Silent.
    void choose(const QString& path);
    /// Empty: the one that comes with the robot.
    QString path() const;
    bool empty() const { return behavior_id_.empty(); }

signals:
    /// By the person; empty for the robot's own.
    void chosen(const QString& path);
    /// The person wants a file that is not in the list.
    void openRequested();
    /// The person wants to change the plan that is chosen.
    void editRequested();

private:
    QToolButton* addButton(const QString& icon_name, const QString& text, const QString& help);

    QComboBox* box_;
    std::string behavior_id_; ///< empty: no plan decides
    std::map<std::string, QStringList> paths_;
};

} // namespace usar::widgets
