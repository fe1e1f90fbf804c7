// Lists the robot plugins: which were found, which were refused and why, and which run in a process of their own.
#pragma once

#include <optional>
#include <vector>

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <QTreeWidget>

namespace usar::widgets {

/// A plugin as the list shows it.
struct PluginRow {
    QString name;    ///< as its author calls it; the file's name where that is not known
    QString version; ///< empty: its author gives none
    QString state;   ///< in words: "loaded", "refused"
    QString reason;  ///< why it was refused, and what to do; empty otherwise
    QStringList behaviors;
    QStringList robots;             ///< classes on the wire that it needs
    QStringList sensors;            ///< types on the wire that its behaviors need; empty: none, or not known
    QString file;                   ///< full path
    std::optional<bool> isolated{}; ///< absent: without a name of its author's it cannot be
    bool operator==(const PluginRow&) const = default;
};

/// One row for each plugin; below, all that is known about the selected one. A check mark in the last column gives the
/// plugin a process of its own. It is not modal. GUI thread.
class PluginDialog : public QDialog {
    Q_OBJECT
public:
    /// `folders`: where plugins are looked for, for the sentence of an empty list.
    explicit PluginDialog(const QStringList& folders, QWidget* parent = nullptr);

    /// Replaces all rows and keeps the selected one by its file; emits nothing.
    void setPlugins(const std::vector<PluginRow>& plugins);
    const std::vector<PluginRow>& plugins() const { return plugins_; }
    /// What is said about the selected plugin; a sentence without one.
    QString details() const { return details_->text(); }
    QSize sizeHint() const override { return {720, 420}; }

signals:
    void rescanRequested();
    /// `plugin`: its name.
    void isolationRequested(const QString& plugin, bool isolated);

private:
    void showDetails();

    QStringList folders_;
    std::vector<PluginRow> plugins_;
    QTreeWidget* list_ = new QTreeWidget(this);
    QLabel* details_ = new QLabel(this);
    QPushButton* rescan_ = new QPushButton(tr("Look for new plugins"), this);
    QPushButton* close_ = new QPushButton(tr("Close"), this);
};

} // namespace usar::widgets
