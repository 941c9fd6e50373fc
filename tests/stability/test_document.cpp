// docs/stability.md: every row of its tables of cases names tests, and those exist in this program.
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace eikonal {
namespace {

std::set<std::string> existingTests() {
    std::set<std::string> names;
    const ::testing::UnitTest& all = *::testing::UnitTest::GetInstance();
    for (int i = 0; i < all.total_test_suite_count(); ++i) {
        const ::testing::TestSuite& suite = *all.GetTestSuite(i);
        for (int j = 0; j < suite.total_test_count(); ++j) {
            names.insert(std::string(suite.name()) + "." + suite.GetTestInfo(j)->name());
        }
    }
    return names;
}

/// What stands between backticks.
std::vector<std::string> quotedIn(const std::string& text) {
    std::vector<std::string> quoted;
    for (std::size_t open = text.find('`'); open != std::string::npos;) {
        const std::size_t close = text.find('`', open + 1);
        if (close == std::string::npos) break;
        quoted.push_back(text.substr(open + 1, close - open - 1));
        open = text.find('`', close + 1);
    }
    return quoted;
}

std::string lastCellOf(const std::string& row) {
    const std::size_t end = row.rfind('|');
    const std::size_t begin = row.rfind('|', end - 1);
    return row.substr(begin + 1, end - begin - 1);
}

/// Rows of tables whose last column is `test`, each with the suite that its section's heading names.
struct Row {
    std::string suite, test;
};

std::vector<Row> rowsOf(const std::string& document) {
    std::vector<Row> rows;
    std::string suite;
    bool isTable = false;  // with such a column
    std::istringstream lines(document);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("## ")) {
            const std::vector<std::string> suites = quotedIn(line);
            suite = suites.empty() ? "" : suites.front();
        }
        if (!line.starts_with('|')) {
            isTable = false;
        } else if (lastCellOf(line) == " test ") {
            isTable = true;
        } else if (isTable && !line.starts_with("|-")) {
            rows.push_back({suite, lastCellOf(line)});
        }
    }
    return rows;
}

TEST(StabilityDocument, EveryRowNamesTestsThatExist) {
    const std::set<std::string> existing = existingTests();
    const std::vector<Row> rows = rowsOf(test::readText(EIKONAL_STABILITY_DOCUMENT));
    EXPECT_GT(rows.size(), 40u);  // boundaries, rays, foci, lights, domains, ranges, cameras
    bool named = false;
    for (const Row& row : rows) {
        const std::vector<std::string> tests = quotedIn(row.test);
        EXPECT_TRUE(!tests.empty() || (named && row.test == " the same ")) << row.suite << ":" << row.test;
        named = true;
        for (const std::string& name : tests) {
            const std::string full = name.find('.') == std::string::npos ? row.suite + "." + name : name;
            EXPECT_EQ(existing.count(full), 1u) << full;
        }
    }
}

} // namespace
} // namespace eikonal
