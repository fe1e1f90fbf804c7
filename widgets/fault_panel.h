// What can be made to go wrong in the simulator, set up, let go and ended.
#pragma once

#include <vector>

#include <QAction>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QWidget>

namespace usar::widgets {

class EmptyState;
class QuantityBox;

/// A number of a kind of fault, with its unit as people write it.
struct FaultQuantity {
    QString key;
    QString unit;
    double smallest = 0.0;
    double largest = 0.0;
    double usual = 0.0;
    QString help;
};

struct FaultKindInfo {
    QString word; ///< as the text form has it: "sensor_bias"
    QString help;
    bool of_robot = true;
    bool of_sensor = false;
    std::vector<FaultQuantity> quantities;
};

enum class FaultState { ToCome, Active, Over };

struct FaultRow {
    int id = 0;
    QString text;
    FaultState state = FaultState::ToCome;
    QString when; ///< "from 60 s for 30 s"
    bool operator==(const FaultRow&) const = default;
};

/// A form that writes a fault as its line of text, which a mission file takes, too, and the list of the run's faults.
/// Values in by setters, intent out by signals. For a narrow dock. GUI thread.
class FaultPanel : public QWidget {
    Q_OBJECT
public:
    explicit FaultPanel(QWidget* parent = nullptr);

    void setKinds(std::vector<FaultKindInfo> kinds);
    void setRobots(const QStringList& names);
    /// What was chosen or typed stays.
    void setSensors(const QStringList& names);
    /// The newest at the top; a selected one that is still there stays selected.
    void setFaults(const std::vector<FaultRow>& faults);
    /// False: nobody is there who could make faults; the empty state says who could.
    void setAvailable(bool on);

    /// "wind speed=5 from=60"; its times count from now.
    QString text() const;
    /// The selected one that is not over; 0 where there is none.
    int endable() const;
    bool anyToEnd() const;
    EmptyState* emptyState() const { return empty_state_; }
    /// The buttons trigger these and are enabled with them; they must outlive this.
    void setActions(QAction* inject, QAction* end);
    QSize sizeHint() const override { return {300, 480}; }

signals:
    /// Of `endable`.
    void selectionChanged();

private:
    struct Field {
        QString key;
        QuantityBox* box = nullptr;
        double usual = 0.0;
    };

    void makeForm();
    void makeList();
    void showKind();
    Field addNumber(const FaultQuantity& quantity);
    void showText();

    std::vector<FaultKindInfo> kinds_;
    QComboBox* kind_;
    QLabel* help_;
    QFormLayout* form_;
    QComboBox* robot_;
    QComboBox* sensor_;
    QuantityBox* from_;
    QuantityBox* lasts_;
    std::vector<Field> fields_; ///< of the shown kind
    QLabel* text_;
    QPushButton* inject_;
    QTreeWidget* list_;
    QPushButton* end_;
    EmptyState* empty_state_;
};

} // namespace usar::widgets
