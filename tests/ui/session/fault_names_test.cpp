#include "tools/english.h"
#include "ui/session/fault_names.h"

#include <gtest/gtest.h>
#include <set>

namespace sandbox {
namespace {

TEST(FaultNames, EveryFaultHasItsOwnAndNothingElseHasOne) {
    std::set<std::string> names;
    std::size_t faults = 0;
    for (const TechniqueKey &key : technique_keys()) {
        for (int value = 0; value < static_cast<int>(key.values.size()); ++value) {
            const bool fault = key.is_fault() && value != 0;
            EXPECT_EQ(!fault_name(english, key, value).empty(), fault) << key.name << " " << value;
            if (fault) {
                names.insert(fault_name(english, key, value));
                ++faults;
            }
        }
    }
    EXPECT_EQ(names.size(), faults);
}

} // namespace
} // namespace sandbox
