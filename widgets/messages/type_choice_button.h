// Button that shows which types of lines are listed, and opens a list with check boxes for the types seen so far.
#pragma once

#include <functional>

#include <QListWidget>
#include <QToolButton>

#include "widgets/models/messages/message_filter.h"

namespace usar::widgets {

/// The list opens below the button and stays open while boxes are checked. GUI thread.
class TypeChoiceButton : public QToolButton {
    Q_OBJECT
public:
    /// Number of lines of each type; queried whenever the list opens.
    using Counts = std::map<std::string, int, std::less<>>;

    explicit TypeChoiceButton(QWidget* parent = nullptr);

    void setCounts(std::function<Counts()> counts) { counts_ = std::move(counts); }
    const TypeChoice& choice() const { return choice_; }
    /// Sets the choice without emitting choiceChanged.
    void setChoice(const TypeChoice& choice);
    /// Lists the types seen so far and those already chosen, with check boxes.
    void openList();
    /// The list of the popup; owned by the button.
    QListWidget* list() const { return list_; }
    QSize sizeHint() const override;

signals:
    /// By the user.
    void choiceChanged();

private:
    QWidget* makePopup();
    void fill();
    void choose(const TypeChoice& choice);
    void takeTick(const QListWidgetItem* item);
    void showChoice();

    std::function<Counts()> counts_;
    TypeChoice choice_;
    QListWidget* list_ = nullptr; ///< made with the popup
    QWidget* popup_;
};

} // namespace usar::widgets
