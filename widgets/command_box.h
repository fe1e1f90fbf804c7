// Where a person types a raw command: completion from the grammar, history, and what is wrong by column.
#pragma once

#include <QCompleter>
#include <QLabel>
#include <QPushButton>
#include <QStandardItemModel>
#include <QTimer>
#include <QWidget>

#include "widgets/command_line.h"
#include "widgets/models/line_history.h"

namespace usar::widgets {

/// Enter sends. A line with an error is sent by a second Enter only; a warning (a word that no table knows) keeps
/// nobody from sending. Tab takes a completion, the arrow keys walk through the history: through those lines that
/// contain what was typed. GUI thread.
class CommandBox : public QWidget {
    Q_OBJECT
public:
    explicit CommandBox(QWidget* parent = nullptr);

    /// Who gets the line ("R1"), and why not, empty where it can be sent.
    void setTarget(const QString& name, const QString& refusal);
    QStringList history() const { return history_.lines(); }
    void setHistory(const QStringList& lines) { history_.setLines(lines); }
    /// Under the line; stays until the text changes.
    void complain(Severity severity, const QString& sentence);
    CommandLine* line() const { return line_; }
    /// What is said under the line; empty where nothing is.
    QString complaint() const { return complaint_->isHidden() ? QString() : complaint_->text(); }
    /// The completions there are to choose from now.
    const QCompleter* completer() const { return completer_; }
    /// All that may stand at the cursor.
    void openCompletions();

signals:
    /// One line without its end.
    void sendRequested(const QString& line);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setUpCompleter();
    void takeEdit();
    bool takeKey(int key, Qt::KeyboardModifiers modifiers);
    bool popupOpen() const;
    bool chosenInPopup() const;
    void showHistory(const std::optional<QString>& line);
    bool acceptFirst();
    void accept(const QModelIndex& index);
    /// Says what is wrong; of a word that is still being typed only when `all`.
    Diagnostics check(bool all);
    void send();

    LineHistory history_;
    CommandLine* line_;
    QPushButton* send_;
    QLabel* complaint_;
    QCompleter* completer_;
    QStandardItemModel* completions_;
    QTimer idle_{this};
    QString refusal_;
    QString sent_anyway_; ///< a second Enter sends this line, whatever is wrong with it
};

} // namespace usar::widgets
