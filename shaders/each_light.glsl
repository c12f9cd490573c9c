#if light.many
    for (int i = 0; i < ${light.count}; ++i) {
        sum += ${light.kind}_light(${light.kind}_lights[i]${light.arguments});
    }
#else
    sum += ${light.kind}_light(the_${light.kind}_light${light.arguments});
#endif
